#include <ros/ros.h>
#include <std_msgs/String.h>
ros::NodeHandle nh;  // expect: finding library-started-late "/global uses roscpp before it initialises it"
int main(int argc, char **argv) {
  ros::init(argc, argv, "global");
  ros::Publisher pub = nh.advertise<std_msgs::String>("x", 1);
  pub.publish(std_msgs::String());
  int hz = 10;
  ros::Timer timer = nh.createTimer(ros::Duration(1 / hz), [](const ros::TimerEvent &) {});  // expect: finding period-of-zero "*"
  ros::spin();
}
