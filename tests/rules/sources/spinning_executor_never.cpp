// An executor has the node and never spins; that the program makes it, and waits for a service, says nothing.
//
// expect: 1 = count : { never_spun(_) }
// expect: 0 = count : { runs_too_little(_, _) }
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/int32.hpp>
#include <std_srvs/srv/trigger.hpp>

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("level");
  auto sub = node->create_subscription<std_msgs::msg::Int32>("level", 1, [](const std_msgs::msg::Int32&) {});
  auto client = node->create_client<std_srvs::srv::Trigger>("reset");
  client->wait_for_service();
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  while (rclcpp::ok()) rclcpp::sleep_for(std::chrono::seconds(1));
}
