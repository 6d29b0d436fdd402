// A listener of transforms and a static broadcaster that end with the function that makes them. What the function waits with, and what only main holds, lasts.
//
// expect: 1 = count : { ends_too_early(_, "transform listener") }, 1 = count : { ends_too_early(_, "static broadcaster") }, 2 = count : { ends_too_early(_, _) }
#include <geometry_msgs/msg/transform_stamped.hpp>
#include <rclcpp/rclcpp.hpp>
#include <tf2_ros/buffer.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_listener.h>

class Watch : public rclcpp::Node {
public:
  Watch() : Node("watch"), buffer_(get_clock()), held_(buffer_), kept_(this) {
    tf2_ros::TransformListener listener(buffer_);
    tf2_ros::StaticTransformBroadcaster fixed(this);
    fixed.sendTransform(geometry_msgs::msg::TransformStamped());
    kept_.sendTransform(geometry_msgs::msg::TransformStamped());
  }
  void waits() {
    tf2_ros::Buffer buffer(get_clock());
    tf2_ros::TransformListener listener(buffer);
    buffer.lookupTransform("map", "odom", tf2::TimePointZero, tf2::durationFromSec(1.0));
  }

private:
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener held_;
  tf2_ros::StaticTransformBroadcaster kept_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Watch>();
  tf2_ros::StaticTransformBroadcaster of_main(node);
  of_main.sendTransform(geometry_msgs::msg::TransformStamped());
  node->waits();
  rclcpp::spin(node);
}
