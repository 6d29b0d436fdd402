// Transports that subscribers of images ask for, and their quality of service.
//
// expect: asks_transport([_, _, "front"], "compressed")
// expect: asks_transport([_, _, "back"], "raw")
// expect: 2 = count : { asks_transport(_, _) }
// expect: port_quality([_, _, "front"], "reliability", "reliable")
// expect: port_quality([_, _, "back"], "reliability", "best_effort")
#include <string>
#include "image_transport/image_transport.hpp"
#include "rclcpp/rclcpp.hpp"

void onImage(const sensor_msgs::msg::Image::ConstSharedPtr &) {}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("view");
  auto front = image_transport::create_subscription(node.get(), "front", onImage, "compressed");
  auto back = image_transport::create_subscription(node.get(), "back", onImage, "raw", rmw_qos_profile_sensor_data);
  auto asked = image_transport::create_subscription(node.get(), "asked", onImage, node->declare_parameter<std::string>("transport"));
  rclcpp::spin(node);
  rclcpp::shutdown();
}
