// Frames of which the code does not tell all, and one that is one of two.
//
// expect: Count = count : { sends_other_frame(C) }, Count = 2
// expect: Count = count : { may_send_frame(C, Frame, P) }, Count = 1
// expect: may_send_frame(C, "base", "")
// expect: Count = count : { looks_up_frame(C, End, Frame, P) }, Count = 1
// expect: looks_up_frame(C, "target", "map", "")
#include <geometry_msgs/TransformStamped.h>
#include <ros/ros.h>
#include <string>
#include <tf/transform_broadcaster.h>
#include <tf/transform_listener.h>

std::string frameOf(const std::string& name);

void onTransform(const geometry_msgs::TransformStamped& message)
{
  static tf::TransformBroadcaster broadcaster;
  broadcaster.sendTransform(message);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  ros::Subscriber sub = nh.subscribe("/in", 1, onTransform);
  tf::TransformListener listener;
  tf::TransformBroadcaster broadcaster;
  std::string source = "laser";
  if (argc > 1)
    source = "camera";
  tf::StampedTransform transform;
  listener.lookupTransform("map", source, ros::Time(0), transform);
  broadcaster.sendTransform(tf::StampedTransform(tf::Transform(), ros::Time::now(), "base", frameOf("x")));
  ros::spin();
}
