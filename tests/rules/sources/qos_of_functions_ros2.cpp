// Qualities of service that functions give back, some of them with a policy set in the structure that the quality holds.
//
// expect: publisher newest std_msgs/Bool queue=1 latched=false
// expect: port_quality([_, _, "newest"], "reliability", "best_effort")
// expect: publisher kept std_msgs/Bool queue=2 latched
// expect: port_quality([_, _, "kept"], "reliability", "reliable")
// expect: 1 = count : { port_quality([_, _, "kept"], "durability", _) }
// expect: publisher shared std_msgs/Bool queue=4 latched
// expect: publisher sensed std_msgs/Bool queue=1 latched=false
// expect: port_quality([_, _, "sensed"], "reliability", "best_effort")
// expect: 4 = count : { port_queue(_, _) }
#include <autoware_utils_rclcpp/polling_subscriber.hpp>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>

rclcpp::SensorDataQoS newest()
{
  rclcpp::SensorDataQoS qos;
  qos.get_rmw_qos_profile().depth = 1;
  return qos;
}

rclcpp::QoS kept(size_t depth)
{
  rclcpp::QoS qos(depth);
  qos.get_rmw_qos_profile().durability = RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL;
  return qos;
}

const rclcpp::QoS & shared()
{
  static const rclcpp::QoS qos = rclcpp::SensorDataQoS().keep_last(4).transient_local();
  return qos;
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("talker");
  using Bool = std_msgs::msg::Bool;
  auto first = node->create_publisher<Bool>("newest", newest());
  auto second = node->create_publisher<Bool>("kept", kept(2));
  auto third = node->create_publisher<Bool>("shared", shared());
  auto fourth = node->create_publisher<Bool>("sensed", autoware_utils_rclcpp::single_depth_sensor_qos());
  rclcpp::spin(node);
}
