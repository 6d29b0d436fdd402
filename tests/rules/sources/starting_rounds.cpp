// Loops that let callbacks run, of ROS 2: at most one message from each queue a round.
//
// expect: serves_one(_)
// expect: N = count : { serves_one(_) }, N = 1
// expect: N = count : { serves_callbacks(_) }, N = 0
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("viewer");
  auto subscription = node->create_subscription<std_msgs::msg::Bool>("image", 10, [](const std_msgs::msg::Bool &) {});
  rclcpp::Rate rate(10);
  while (rclcpp::ok()) {
    rclcpp::spin_some(node);
    rate.sleep();
  }
}
