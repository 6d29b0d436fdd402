// a flag that two callbacks set, one that is true at first, one that is asked for only sometimes
#include <ros/ros.h>
#include <std_msgs/String.h>

ros::Publisher first, second, third;
bool either = false, ready = true, sometimes = false;

void onOdom(const std_msgs::String&) {
  either = true;
  ready = true;
  sometimes = true;
}
void onPose(const std_msgs::String&) { either = true; }
void onPath(const std_msgs::String& path) {
  if (either) first.publish(path);
  if (ready) second.publish(path);
  if (sometimes || path.data.empty()) third.publish(path);
}
void onStop(const std_msgs::String&) { ready = false; }

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  first = nh.advertise<std_msgs::String>("/first", 1);
  second = nh.advertise<std_msgs::String>("/second", 1);
  third = nh.advertise<std_msgs::String>("/third", 1);
  ros::Subscriber odom = nh.subscribe("/odom", 1, onOdom);
  ros::Subscriber pose = nh.subscribe("/pose", 1, onPose);
  ros::Subscriber path = nh.subscribe("/path", 1, onPath);
  ros::Subscriber stop = nh.subscribe("/stop", 1, onStop);
  ros::spin();
}
