#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto a = std::make_shared<rclcpp::Node>("a");
  auto b = std::make_shared<rclcpp::Node>("b");
  auto sub = b->create_subscription<std_msgs::msg::String>("x", 1, [](std_msgs::msg::String::SharedPtr) {});
  rclcpp::spin(a);
  rclcpp::spin(b);  // expect: finding after-spin "*spins another node only after its spin has ended*"
  rclcpp::shutdown();
}
