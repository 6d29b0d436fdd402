// A loop over publishers sends through each of them; what else its rounds send needs one of them, and a container that a callback fills may be empty.
//
// expect: reactive /in -> /first must
// expect: reactive /in -> /beside may
// expect: reactive /in -> /added may
// expect-only: reactive
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <vector>

std::vector<ros::Publisher> fixed, growing;
ros::Publisher beside, added;

void onIn(const std_msgs::Empty& message) {
  for (ros::Publisher& each : fixed) {
    each.publish(message);
    beside.publish(message);
  }
  for (ros::Publisher& each : growing) each.publish(message);
}

void onMore(const std_msgs::Empty&) { growing.push_back(added); }

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  beside = nh.advertise<std_msgs::Empty>("/beside", 1);
  added = nh.advertise<std_msgs::Empty>("/added", 1);
  fixed.push_back(nh.advertise<std_msgs::Empty>("/first", 1));
  ros::Subscriber in = nh.subscribe("/in", 1, onIn), more = nh.subscribe("/more", 1, onMore);
  ros::spin();
}
