// A thread that is given the method of an executor spins, though nothing calls it.
//
// expect-not: never_spun(_)
// expect: subscriber level
#include <thread>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/int32.hpp>

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("level");
  auto sub = node->create_subscription<std_msgs::msg::Int32>("level", 1, [](const std_msgs::msg::Int32&) {});
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  std::thread thread(&rclcpp::Executor::spin, &executor);
  while (rclcpp::ok()) rclcpp::sleep_for(std::chrono::seconds(1));
  thread.join();
}
