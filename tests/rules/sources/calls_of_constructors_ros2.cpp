// Of two constructors the one runs that takes what is given: no quality of service is made of a callback.
//
// expect: subscriber speed std_msgs/Float64 queue=10 callback=Base::onSpeed
// expect: subscriber speed std_msgs/Int64 queue=10 callback=Base::onStep
// expect: subscriber limit std_msgs/Int64 queue=10 callback=Base::onStep
// expect-only: subscriber
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/float64.hpp>
#include <std_msgs/msg/int64.hpp>

class Either
{
public:
  template <typename A, typename B>
  Either(rclcpp::Node * node, const std::string & topic, A && speed, B && step, const rclcpp::QoS & qos = rclcpp::QoS(10))
  {
    if (node->declare_parameter("steps", false)) {
      steps_ = node->create_subscription<std_msgs::msg::Int64>(topic, qos, std::forward<B>(step));
    } else {
      speeds_ = node->create_subscription<std_msgs::msg::Float64>(topic, qos, std::forward<A>(speed));
    }
  }

  template <typename B>
  Either(rclcpp::Node * node, const std::string & topic, B && step, const rclcpp::QoS & qos = rclcpp::QoS(10))
  {
    steps_ = node->create_subscription<std_msgs::msg::Int64>(topic, qos, std::forward<B>(step));
  }

private:
  rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr speeds_;
  rclcpp::Subscription<std_msgs::msg::Int64>::SharedPtr steps_;
};

class Base : public rclcpp::Node
{
public:
  Base() : Node("base")
  {
    either_ = std::make_unique<Either>(this, "speed", std::bind(&Base::onSpeed, this, std::placeholders::_1), std::bind(&Base::onStep, this, std::placeholders::_1));
    limit_ = std::make_unique<Either>(this, "limit", std::bind(&Base::onStep, this, std::placeholders::_1));
  }

private:
  void onSpeed(std_msgs::msg::Float64::ConstSharedPtr) {}
  void onStep(std_msgs::msg::Int64::ConstSharedPtr) {}

  std::unique_ptr<Either> either_, limit_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Base>());
}
