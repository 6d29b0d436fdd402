// Sends nothing before a first `pong` has arrived; its `hello` waits for nothing.
// expect: publisher ping
#include <ros/ros.h>
#include <std_msgs/Empty.h>

bool has_pong = false;

void onPong(const std_msgs::Empty&) { has_pong = true; }

int main(int argc, char** argv) {
  ros::init(argc, argv, "ping");
  ros::NodeHandle nh;
  ros::Publisher ping_pub = nh.advertise<std_msgs::Empty>("ping", 1);
  ros::Publisher hello_pub = nh.advertise<std_msgs::Empty>("hello", 1);
  ros::Subscriber sub = nh.subscribe("pong", 1, onPong);
  for (ros::Rate rate(10); ros::ok(); rate.sleep()) {
    ros::spinOnce();
    hello_pub.publish(std_msgs::Empty());
    if (has_pong) ping_pub.publish(std_msgs::Empty());
  }
}
