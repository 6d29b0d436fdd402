// A single source is a test, and all that a report of a defect needs: what rosarch should find in it is said in comments.
//
// expect: component wall_follower node_name=wall_follower
// expect: param ~speed = 0.5
// expect: reactive /scan -> /cmd_vel must
// expect-not: reactive /scan -> /near
// expect: port([_, "publisher", Name]), port_type([_, "publisher", Name], "std_msgs/Bool")
// expect: Count = count : { port([_, "publisher", _]) }, Count = 2
#include <geometry_msgs/Twist.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Bool.h>

ros::Publisher g_command_pub;
double g_speed = 0.0;
bool g_near = false;  // expect: state g_near = false

void onScan(const sensor_msgs::LaserScan& scan)
{
  if (scan.ranges.front() < 1.0)
    g_near = true;  // expect: transition g_near = true on /scan if "scan.ranges.front() < 1.0"
  geometry_msgs::Twist command;
  command.linear.x = g_near ? 0.0 : g_speed;
  g_command_pub.publish(command);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "wall_follower");
  ros::NodeHandle nh, private_nh("~");
  g_speed = private_nh.param("speed", 0.5);
  g_command_pub = nh.advertise<geometry_msgs::Twist>("/cmd_vel", 1);  // expect: publisher /cmd_vel geometry_msgs/Twist queue=1
  ros::Publisher near_pub = nh.advertise<std_msgs::Bool>("/near", 1);
  // expect: finding subscriber-without-publisher
  ros::Subscriber scan_sub = nh.subscribe("/scan", 1, onScan);  // expect: subscriber /scan callback=onScan
  ros::Rate rate(10);  // expect-not: finding *
  while (ros::ok())
  {
    std_msgs::Bool message;
    message.data = true;
    if (g_near)
      near_pub.publish(message);
    ros::spinOnce();
    rate.sleep();  // expect: periodic /near 10 Hz mechanism=rate if g_near
  }
}
