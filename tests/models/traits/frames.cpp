// expect: keeps_value_of more ~more
// expect: reads_clock 29
// expect: reads_clock 30
// expect: reads_clock 31
// expect: may_send_frame 29 base_link ~base_frame
// expect: may_send_frame 29 odom 
// expect: may_send_frame 30 map 
// expect: may_send_frame 30 odom 
// expect: may_send_frame 31 laser 
// expect: may_send_frame 31 map 
// expect: sends_frame 29 base_link ~base_frame
// expect: sends_frame 30 odom 
#include <string>
#include <ros/ros.h>
#include <tf/transform_broadcaster.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle pnh("~");
  std::string frame;
  bool more;
  pnh.param<std::string>("base_frame", frame, "base_link");
  pnh.param("more", more, false);
  tf::TransformBroadcaster broadcaster;
  tf::Transform transform;
  ros::Rate rate(10);
  while (ros::ok()) {
    // always, and only when asked to
    broadcaster.sendTransform(tf::StampedTransform(transform, ros::Time::now(), "odom", frame));
    broadcaster.sendTransform(tf::StampedTransform(transform, ros::Time::now(), "map", "odom"));
    if (more) broadcaster.sendTransform(tf::StampedTransform(transform, ros::Time::now(), "map", "laser"));
    rate.sleep();
  }
}
