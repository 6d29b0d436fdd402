// Parameters that should name a topic or service, and do not: the name that they default to is written out where the port is made.
//
// expect: Count = count : { names_nothing(C, P, Port) }, Count = 4
// expect: names_nothing(_, "~scan_topic", [_, "subscriber", "scan"])
// expect: names_nothing(_, "~odom/topic", [_, "publisher", "/odom"])
// expect: names_nothing(_, "~service", [_, "service_client", "reset"])
// expect: names_nothing(_, "~topic_name", [_, "publisher", "plan"])
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Empty.h>
#include <string>

void onScan(const sensor_msgs::LaserScan&) {}
void onMap(const std_msgs::Bool&) {}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh, private_nh("~");
  std::string scan, odom, service, plan, map, frame, none, topical, written;
  private_nh.param<std::string>("scan_topic", scan, "scan");
  private_nh.param<std::string>("odom/topic", odom, "odom");
  private_nh.param<std::string>("service", service, "reset");
  private_nh.param<std::string>("topic_name", plan, "/plan");
  private_nh.param<std::string>("map_topic", map, "map");        // it is used
  private_nh.param<std::string>("frame", frame, "scan");         // it names no topic
  private_nh.param<std::string>("empty_topic", none, "");
  private_nh.param<std::string>("topical", topical, "scan");     // another word
  private_nh.param<std::string>("fixed_topic", scan, "fixed");   // the name is written elsewhere
  private_nh.setParam("written_topic", "scan");
  ros::Subscriber sub = nh.subscribe("scan", 1, onScan);
  ros::Publisher odom_pub = nh.advertise<nav_msgs::Odometry>("/odom", 1);
  ros::Publisher plan_pub = nh.advertise<nav_msgs::Path>("plan", 1);
  ros::ServiceClient client = nh.serviceClient<std_srvs::Empty>("reset");
  ros::Subscriber map_sub = nh.subscribe(map, 1, onMap);
  ros::Subscriber again_sub = nh.subscribe("map", 1, onMap);
  const std::string fixed = "fixed";
  ros::Publisher fixed_pub = nh.advertise<nav_msgs::Path>(fixed, 1);
  ros::spin();
}
