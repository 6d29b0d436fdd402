// expect: sleeps_for_each always 0.1 1
// `at_times` need not sleep
#include <ros/ros.h>
#include <std_msgs/Bool.h>

ros::Publisher pub;

void onAlways(const std_msgs::Bool& msg) {
  ros::Duration(0.1).sleep();
  pub.publish(msg);
}
void onAtTimes(const std_msgs::Bool& msg) {
  if (msg.data) ros::Duration(0.2).sleep();
  pub.publish(msg);
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  pub = nh.advertise<std_msgs::Bool>("out", 1);
  ros::Subscriber always = nh.subscribe("always", 1, onAlways);
  ros::Subscriber at_times = nh.subscribe("at_times", 1, onAtTimes);
  ros::spin();
}
