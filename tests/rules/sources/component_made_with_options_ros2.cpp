// Of the constructors of a component the one with options is called.
//
// expect: publisher with_options std_msgs/String
// expect-not: publisher without_options
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/string.hpp>

namespace demo {
class Talker : public rclcpp::Node {
public:
  Talker() : rclcpp::Node("talker") { publisher_ = create_publisher<std_msgs::msg::String>("without_options", 10); }
  explicit Talker(const rclcpp::NodeOptions& options) : rclcpp::Node("talker", options) {
    publisher_ = create_publisher<std_msgs::msg::String>("with_options", 10);
  }

private:
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr publisher_;
};
}  // namespace demo

RCLCPP_COMPONENTS_REGISTER_NODE(demo::Talker)
