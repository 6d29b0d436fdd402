// expect: keeps_value_of topic ~scan_topic
// expect: serves_callbacks 23
// expect: names_nothing 16 ~scan_topic /scan
// expect: misused 16 value unused ~scan_topic
#include <string>
#include <ros/ros.h>
#include <std_msgs/String.h>

void onScan(const std_msgs::String&) {}

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh, pnh("~");
  std::string topic;
  std::string used;
  pnh.param<std::string>("scan_topic", topic, "/scan");
  pnh.param<std::string>("path_topic", used, "/path");
  ros::Subscriber sub = nh.subscribe("/scan", 10, onScan);
  ros::Subscriber path = nh.subscribe(used, 10, onScan);
  std::string space = ros::this_node::getNamespace();
  pnh.param<std::string>("pose_topic", used, "/pose");
  ros::Subscriber pose = nh.subscribe(space + used, 10, onScan);
  for (ros::Rate rate(5); ros::ok(); rate.sleep()) ros::spinOnce();
}
