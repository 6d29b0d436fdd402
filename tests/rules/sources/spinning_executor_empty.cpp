// An executor that nothing gives a node, and one that has it.
//
// expect: 1 = count : { runs_too_little(_, "no_node") }
// expect: 0 = count : { runs_too_little(_, "once") }
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/int32.hpp>

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("level");
  auto sub = node->create_subscription<std_msgs::msg::Int32>("level", 1, [](const std_msgs::msg::Int32&) {});
  rclcpp::executors::SingleThreadedExecutor other;
  other.add_node(node);
  other.spin();
  rclcpp::executors::MultiThreadedExecutor executor;
  executor.spin();
}
