// Which field of a message is made from which field of the one that arrived.
//
// expect: field_flow([_, _, "/in"], "twist.linear.x", [_, _, "/out"], "linear.x")
// expect: field_flow([_, _, "/in"], "twist.linear.y", [_, _, "/out"], "linear.y")
// expect: field_flow([_, _, "/in"], "twist.linear.z", [_, _, "/out"], "linear.z")
// expect: field_flow([_, _, "/in"], "twist.angular.x", [_, _, "/out"], "angular.x")
// expect: field_flow([_, _, "/in"], "header.frame_id", [_, _, "/name"], "data")
// expect: field_flow([_, _, "/in"], "twist.angular.y", [_, _, "/copied"], "angular.y")
// expect: field_flow([_, _, "/in"], "twist.angular.z", [_, _, "/copied"], "angular.z")
// expect: field_flow([_, _, "/in"], "header.seq", [_, _, "/kept"], "data")
// expect: field_flow([_, _, "/scan"], "ranges", [_, _, "/scan_out"], "ranges")
// expect: field_flow([_, _, "/scan"], "angle_min", [_, _, "/scan_out"], "angle_max")
// expect: Count = count : { field_flow(_, _, _, _) }, Count = 10
#include <geometry_msgs/Twist.h>
#include <geometry_msgs/TwistStamped.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Int32.h>
#include <std_msgs/String.h>

ros::Publisher g_pub, g_name_pub, g_copied_pub, g_kept_pub, g_scan_pub;
geometry_msgs::TwistStamped g_last;

struct Settings
{
  double speed;
};

double twice(double value)
{
  return 2 * value;
}

double first(double value, double)
{
  return value;
}

void onIn(const geometry_msgs::TwistStamped::ConstPtr& in)
{
  geometry_msgs::Twist out;
  out.linear.x = in->twist.linear.x;
  out.linear.y = 2 * (*in).twist.linear.y + 1;
  double z = in->twist.linear.z;
  out.linear.z += z;
  out.angular.x = twice(in->twist.angular.x);
  out.angular.y = first(0.5, in->twist.angular.y);
  if (out.angular.z == in->twist.angular.z)
    out.angular.z = 1;
  g_pub.publish(out);

  // not sent
  Settings settings;
  settings.speed = in->twist.linear.x;

  std_msgs::String name;
  name.data = in.get()->header.frame_id;
  g_name_pub.publish(name);

  geometry_msgs::TwistStamped copy = *in, assigned;
  assigned = *in;
  geometry_msgs::Twist copied;
  copied.angular.y = copy.twist.angular.y;
  (&copied)->angular.z = assigned.twist.angular.z;
  g_copied_pub.publish(copied);

  g_last = *in;
}

void onScan(const sensor_msgs::LaserScan& in)
{
  sensor_msgs::LaserScan out;
  for (int i = 0; i < 3; ++i)
    out.ranges[i] = in.ranges[2 - i];
  out.angle_max = -in.angle_min;
  g_scan_pub.publish(out);
}

void onTimer(const ros::TimerEvent&)
{
  std_msgs::Int32 kept;
  kept.data = g_last.header.seq;
  g_kept_pub.publish(kept);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "fields");
  ros::NodeHandle nh;
  g_pub = nh.advertise<geometry_msgs::Twist>("/out", 1);
  g_name_pub = nh.advertise<std_msgs::String>("/name", 1);
  g_copied_pub = nh.advertise<geometry_msgs::Twist>("/copied", 1);
  g_kept_pub = nh.advertise<std_msgs::Int32>("/kept", 1);
  g_scan_pub = nh.advertise<sensor_msgs::LaserScan>("/scan_out", 1);
  ros::Subscriber sub = nh.subscribe("/in", 1, onIn), scan = nh.subscribe("/scan", 1, onScan);
  ros::Timer timer = nh.createTimer(ros::Duration(1.0), onTimer);
  ros::spin();
}
