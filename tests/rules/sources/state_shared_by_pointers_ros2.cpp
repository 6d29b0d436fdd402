// Members of a structure that one object keeps and changes, and another reads through the pointer that it was given.
//
// expect: state Limits::speed
// expect: transition Limits::speed = parameter.as_double() on parameters
// expect-not: transition Limits::speed = initial
// expect: state Modes::quiet
// expect: transition Modes::quiet = quiet->data on quiet
// expect-not: state Limits::range
// expect-not: state Keeper::limits_
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_msgs/msg/float64.hpp>

struct Limits
{
  double speed;
  double range;
};

struct Modes
{
  bool quiet;
};

class Switch
{
public:
  explicit Switch(rclcpp::Node * node) : modes_(std::make_shared<Modes>())
  {
    sub_ = node->create_subscription<std_msgs::msg::Bool>(
      "quiet", 1, [this](std_msgs::msg::Bool::ConstSharedPtr quiet) {modes_->quiet = quiet->data;});
  }
  std::shared_ptr<Modes> modes() {return modes_;}

private:
  std::shared_ptr<Modes> modes_;
  rclcpp::Subscription<std_msgs::msg::Bool>::SharedPtr sub_;
};

template <typename T>
class Keeper
{
public:
  T * limits() {return &limits_;}

protected:
  T limits_;
};

class LimitKeeper : public Keeper<Limits>
{
public:
  explicit LimitKeeper(rclcpp::Node * node)
  {
    const double initial = node->declare_parameter("speed", 1.0);
    limits_.speed = initial;
    limits_.range = node->declare_parameter("range", 2.0);
    changed_ = node->add_post_set_parameters_callback(std::bind(&LimitKeeper::onChange, this, std::placeholders::_1));
  }

private:
  void onChange(const std::vector<rclcpp::Parameter> & parameters)
  {
    for (const auto & parameter : parameters) {
      if (parameter.get_name() == "speed") {
        limits_.speed = parameter.as_double();
      }
    }
  }
  rclcpp::node_interfaces::PostSetParametersCallbackHandle::SharedPtr changed_;
};

class Drive : public rclcpp::Node
{
public:
  Drive() : Node("drive"), switch_(this), modes_(switch_.modes())
  {
    start_ = create_subscription<std_msgs::msg::Bool>("start", 1, [this](std_msgs::msg::Bool::ConstSharedPtr) {
      keeper_ = std::make_unique<LimitKeeper>(this);
      limits_ = keeper_->limits();
    });
    pub_ = create_publisher<std_msgs::msg::Float64>("out", 1);
    sub_ = create_subscription<std_msgs::msg::Float64>("in", 1, [this](std_msgs::msg::Float64::ConstSharedPtr speed) {
      if (!modes_->quiet && speed->data < limits_->speed && speed->data < limits_->range) {
        pub_->publish(*speed);
      }
    });
  }

private:
  std::unique_ptr<LimitKeeper> keeper_;
  Limits * limits_;
  Switch switch_;
  std::shared_ptr<Modes> modes_;
  rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr pub_;
  rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr sub_;
  rclcpp::Subscription<std_msgs::msg::Bool>::SharedPtr start_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Drive>());
}
