#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
int main(int argc, char ** argv)
{
  auto node = std::make_shared<rclcpp::Node>("bad1");  // expect: finding library-started-late "/bad1 uses rclcpp before it initialises it"
  rclcpp::init(argc, argv);
  rclcpp::spin(node);
  rclcpp::shutdown();
}
