// A component whose constructor without arguments is deleted is made with options.
//
// expect: publisher chatter std_msgs/String
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/string.hpp>

namespace demo {
class Silent : public rclcpp::Node {
public:
  Silent() = delete;
  Silent(const Silent&) = delete;
  explicit Silent(const rclcpp::NodeOptions& options) : rclcpp::Node("silent", options) {
    publisher_ = create_publisher<std_msgs::msg::String>("chatter", 10);
  }

private:
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr publisher_;
};
}  // namespace demo

RCLCPP_COMPONENTS_REGISTER_NODE(demo::Silent)
