// Frames that are asked for and sent: in calls of both libraries, through constructors, copies and members.
//
// expect: Count = count : { frame_lookup(C, End, Frame) }, Count = 8
// expect: frame_lookup(_, "target", "map")
// expect: frame_lookup(_, "source", "base")
// expect: frame_lookup(_, "target", "odom")
// expect: frame_lookup(_, "source", "laser")
// expect: frame_lookup(_, "fixed", "world")
// expect: frame_lookup(_, "target", "goal")
// expect: frame_lookup(_, "target", "camera")
// expect: frame_lookup(_, "source", "tool")
// expect: Count = count : { frame_broadcast(C, End, Frame) }, Count = 14
// expect: frame_broadcast(C, "parent", "base"), frame_broadcast(C, "child", "laser")
// expect: frame_broadcast(C, "parent", "base"), frame_broadcast(C, "child", "gps")
// expect: frame_broadcast(C, "parent", "base"), frame_broadcast(C, "child", "made")
// expect: frame_broadcast(C, "parent", "odom"), frame_broadcast(C, "child", "base")
// expect: frame_broadcast(C, "parent", "base"), frame_broadcast(C, "child", "again")
// expect: frame_broadcast(C, "parent", "odom"), frame_broadcast(C, "child", "named")
// expect: frame_broadcast(C, "parent", "base"), frame_broadcast(C, "child", "sometimes")
// expect: Count = count : { sends_frame(C, Child, P) }, Count = 6
// expect: sends_frame(C, "laser", "")
// expect: sends_frame(C, "gps", "")
// expect: sends_frame(C, "made", "")
// expect: sends_frame(C, "base", "")
// expect: sends_frame(C, "again", "")
// expect: sends_frame(C, "named", "~child")
// expect: Count = count : { may_send_frame(C, Frame, P) }, Count = 14
// expect: may_send_frame(C, "named", "~child"), may_send_frame(C, "odom", "")
// expect: Count = count : { sends_other_frame(C) }, Count = 0
// expect: Count = count : { looks_up_frame(C, End, Frame, P) }, Count = 7
// expect: looks_up_frame(C, "target", "map", ""), looks_up_frame(C, "source", "base", "")
// expect: 1 = count : { kept_from(_, _, _) }
#include <geometry_msgs/TransformStamped.h>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <string>
#include <tf/transform_broadcaster.h>
#include <tf/transform_listener.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_broadcaster.h>

std::string g_child;
geometry_msgs::PoseStamped g_pose, g_result;

void sendSometimes(tf::TransformBroadcaster& broadcaster)
{
  broadcaster.sendTransform(tf::StampedTransform(tf::Transform(), ros::Time::now(), "base", "sometimes"));
}

void onIn(const std_msgs::Bool& message)
{
  static tf::TransformBroadcaster broadcaster;
  if (message.data)
    sendSometimes(broadcaster);
}

// nobody calls it
void unused(tf::TransformListener& listener, tf::TransformBroadcaster& broadcaster)
{
  tf::StampedTransform transform;
  listener.lookupTransform("never", "unused", ros::Time(0), transform);
  broadcaster.sendTransform(tf::StampedTransform(tf::Transform(), ros::Time::now(), "never", "unused"));
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh, private_nh("~");
  private_nh.param<std::string>("child", g_child, "named");
  ros::Subscriber sub = nh.subscribe("/in", 1, onIn);
  tf::TransformListener listener;
  tf2_ros::Buffer buffer;
  tf::TransformBroadcaster broadcaster;
  tf2_ros::TransformBroadcaster broadcaster2;

  tf::StampedTransform made(tf::Transform(), ros::Time::now(), "base", "made");
  tf::StampedTransform assigned;
  assigned = tf::StampedTransform(tf::Transform(), ros::Time::now(), "base", "again");
  tf::StampedTransform other(tf::Transform(), ros::Time::now(), "other", "unsent");
  tf::StampedTransform parts;
  parts.frame_id_ = "base";
  parts.child_frame_id_ = "gps";
  geometry_msgs::TransformStamped message, named;
  message.header.frame_id = "odom";
  message.header.seq = 1;
  message.child_frame_id = "base";
  named.header.frame_id = "odom";
  named.child_frame_id = g_child;

  ros::Rate rate(10);
  while (ros::ok())
  {
    tf::StampedTransform transform;
    listener.lookupTransform("map", "base", ros::Time(0), transform);
    listener.lookupTransform("odom", ros::Time(0), "laser", ros::Time::now(), "world", transform);
    listener.transformPose("goal", g_pose, g_result);
    if (buffer.canTransform("camera", "tool", ros::Time(0)))
      ROS_INFO("tool seen");
    broadcaster.sendTransform(tf::StampedTransform(tf::Transform(), ros::Time::now(), "base", "laser"));
    broadcaster.sendTransform(made);
    broadcaster.sendTransform(assigned);
    broadcaster.sendTransform(parts);
    broadcaster2.sendTransform(message);
    broadcaster2.sendTransform(named);
    rate.sleep();
    ros::spinOnce();
  }
}
