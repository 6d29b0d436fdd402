// Frames of transforms of ROS 2: given to the fields of a message, copied from another header, and of a parameter.
//
// expect: sends_frame(C, "base_link", ""), sends_from_frame(C, "odom", "")
// expect: sends_frame(C, "laser", ""), sends_from_frame(C, Frame, P), P = "mount"
// expect: 1 = count : { sends_other_frame(_) }
#include <memory>
#include <geometry_msgs/msg/transform_stamped.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <rclcpp/rclcpp.hpp>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

class Base : public rclcpp::Node {
public:
  Base() : Node("base"), broadcaster_(*this) {
    mount_ = declare_parameter("mount", "base_link");
    fixed_ = std::make_unique<tf2_ros::StaticTransformBroadcaster>(*this);
    geometry_msgs::msg::TransformStamped mounted;
    mounted.header.stamp = now();
    mounted.header.frame_id = mount_;
    mounted.child_frame_id = "laser";
    fixed_->sendTransform(mounted);
    timer_ = create_wall_timer(std::chrono::milliseconds(100), [this]() {
      geometry_msgs::msg::TransformStamped t;
      t.header.stamp = now();
      t.header.frame_id = "odom";
      t.child_frame_id = "base_link";
      broadcaster_.sendTransform(t);
    });
    sub_ = create_subscription<nav_msgs::msg::Odometry>("odometry", 10, [this](nav_msgs::msg::Odometry::ConstSharedPtr message) {
      geometry_msgs::msg::TransformStamped t;
      t.header = message->header;
      t.child_frame_id = message->child_frame_id;
      broadcaster_.sendTransform(t);
    });
  }

private:
  tf2_ros::TransformBroadcaster broadcaster_;
  std::unique_ptr<tf2_ros::StaticTransformBroadcaster> fixed_;
  std::string mount_;
  rclcpp::TimerBase::SharedPtr timer_;
  rclcpp::Subscription<nav_msgs::msg::Odometry>::SharedPtr sub_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Base>());
}
