// a timer and a loop that begin with the node and end with it, a callback that nothing holds up
#include <ros/ros.h>
#include <std_msgs/Empty.h>

ros::Publisher beat, echo;

void tick(const ros::TimerEvent&) { beat.publish(std_msgs::Empty()); }
void onIn(const std_msgs::Empty& msg) { echo.publish(msg); }

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  beat = nh.advertise<std_msgs::Empty>("beat", 1);
  echo = nh.advertise<std_msgs::Empty>("echo", 1);
  ros::Subscriber in = nh.subscribe("in", 1, onIn);
  ros::Timer timer = nh.createTimer(ros::Duration(0.1), tick);
  ros::Rate rate(10);
  while (ros::ok()) {
    beat.publish(std_msgs::Empty());
    ros::spinOnce();
    rate.sleep();
  }
}
