// A function puts names of parameters together, for another that declares them with their defaults: each name has its own default.
//
// expect: publisher state std_msgs/Bool queue=10
// expect: publisher left/speed std_msgs/Float64 queue=10
// expect: publisher right/speed std_msgs/Float64 queue=10
// expect-not: publisher true
// expect-not: publisher 0.1
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_msgs/msg/float64.hpp>

class Layer
{
public:
  Layer(rclcpp::Node * node, const std::string & name) : node_(node), name_(name) {}

  std::string fullName(const std::string & name)
  {
    return std::string(name_ + "." + name);
  }

  void declare(const std::string & name, const rclcpp::ParameterValue & value)
  {
    if (!node_->has_parameter(fullName(name))) {
      node_->declare_parameter(fullName(name), value);
    }
  }

  void initialize()
  {
    std::string topic;
    declare("enabled", rclcpp::ParameterValue(true));
    declare("tolerance", rclcpp::ParameterValue(0.1));
    declare("state_topic", rclcpp::ParameterValue("state"));
    node_->get_parameter(name_ + "." + "state_topic", topic);
    state_ = node_->create_publisher<std_msgs::msg::Bool>(topic, 10);
  }

private:
  rclcpp::Node * node_;
  std::string name_;
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr state_;
};

class Wheels
{
public:
  explicit Wheels(rclcpp::Node * node) : node_(node)
  {
    left_ = publisher("left", "speed");
    right_ = publisher("right", "speed");
  }

private:
  std::string inside(const std::string & space, const std::string & name) { return space + "/" + name; }

  rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr publisher(const std::string & side, const std::string & what)
  {
    return node_->create_publisher<std_msgs::msg::Float64>(inside(side, what), 10);
  }

  rclcpp::Node * node_;
  rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr left_, right_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("layers");
  Layer layer(node.get(), "filter");
  layer.initialize();
  Wheels wheels(node.get());
  rclcpp::spin(node);
}
