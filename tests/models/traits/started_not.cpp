// waits for subscribers; sends later; sends one part a round; sends in one round
#include <ros/ros.h>
#include <std_msgs/String.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  ros::Publisher map = nh.advertise<std_msgs::String>("/map", 1);
  ros::Publisher parts = nh.advertise<std_msgs::String>("/parts", 1, true);
  ros::Duration(1.0).sleep();
  std_msgs::String message;
  map.publish(message);
  ros::Rate rate(1);
  for (int i = 0; i < 3; ++i) {
    parts.publish(message);
    rate.sleep();
  }
  for (int i = 0; i < 3; ++i) {
    if (i == 1) parts.publish(message);
  }
  ros::spin();
}
