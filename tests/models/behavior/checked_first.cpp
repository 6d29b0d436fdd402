// What is sent after a call that may throw is not sent for every message.
// expect: reactive in -> out may []
// expect: reactive safe -> echo must []
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <stdexcept>

ros::Publisher out, echo;

void check(int value) {
  if (value < 0) throw std::invalid_argument("negative");
}
void onIn(const std_msgs::Int32& msg) {
  check(msg.data);
  out.publish(msg);
}
void onSafe(const std_msgs::Int32& msg) {
  echo.publish(msg);
  check(msg.data);
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  out = nh.advertise<std_msgs::Int32>("out", 1);
  echo = nh.advertise<std_msgs::Int32>("echo", 1);
  ros::Subscriber in = nh.subscribe("in", 1, onIn);
  ros::Subscriber safe = nh.subscribe("safe", 1, onSafe);
  ros::spin();
}
