#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
int main(int argc, char ** argv)
{
  auto node = std::make_shared<rclcpp::Node>("bad1");  // expect: finding library-started-late "/bad1 makes what needs rclcpp before it starts that"
  rclcpp::init(argc, argv);
  rclcpp::spin(node);
  rclcpp::shutdown();
}
