// A component that waits for an answer in another group: a container with several threads lets it come.
// expect-not: finding callback-deadlock "*/many_relay*"
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/string.hpp>
#include <std_srvs/srv/trigger.hpp>

namespace ros2_checks {
class Relay : public rclcpp::Node {
public:
  explicit Relay(const rclcpp::NodeOptions & options) : Node("relay", options) {
    group_ = create_callback_group(rclcpp::CallbackGroupType::Reentrant);
    client_ = create_client<std_srvs::srv::Trigger>("asked", rclcpp::ServicesQoS(), group_);
    sub_ = create_subscription<std_msgs::msg::String>("text", 10, [this](const std_msgs::msg::String &) {
      client_->async_send_request(std::make_shared<std_srvs::srv::Trigger::Request>()).get();  // expect: finding callback-deadlock "a callback of /one_relay waits*one thread runs all callbacks in its container"
    });
  }

private:
  rclcpp::CallbackGroup::SharedPtr group_;
  rclcpp::Client<std_srvs::srv::Trigger>::SharedPtr client_;
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr sub_;
};
}

RCLCPP_COMPONENTS_REGISTER_NODE(ros2_checks::Relay)
