// Nodes that are given to an executor and spun by another one.
//
// expect: 1 = count : { misused(_, "two executors", _) }
#include <memory>
#include <rclcpp/rclcpp.hpp>

int main(int argc, char **argv) {
  rclcpp::init(argc, argv);
  auto lamp = std::make_shared<rclcpp::Node>("lamp");
  auto knob = std::make_shared<rclcpp::Node>("knob");
  auto door = std::make_shared<rclcpp::Node>("door");
  auto bell = std::make_shared<rclcpp::Node>("bell");
  rclcpp::spin_some(door);
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(lamp);
  executor.add_node(knob);
  executor.add_node(door);
  if (argc > 1) {
    executor.add_node(bell);
  }
  executor.remove_node(knob);
  rclcpp::spin_some(lamp);
  rclcpp::spin_some(knob);
  rclcpp::spin_some(bell);
  rclcpp::shutdown();
  return 0;
}
