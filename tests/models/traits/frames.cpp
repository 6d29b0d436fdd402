// expect: keeps_value_of more ~more
// expect: reads_clock 31
// expect: reads_clock 32
// expect: reads_clock 33
// expect: may_send_frame 31 base_link ~base_frame
// expect: may_send_frame 31 odom 
// expect: may_send_frame 32 map 
// expect: may_send_frame 32 odom 
// expect: may_send_frame 33 laser 
// expect: may_send_frame 33 map 
// expect: sends_frame 31 base_link ~base_frame
// expect: sends_from_frame 31 odom 
// expect: sends_from_frame 32 map 
// expect: sends_frame 32 odom 
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
