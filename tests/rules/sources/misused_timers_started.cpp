// A timer that is started later.
//
// expect: !misused(_, "timer not started", _)
#include <ros/ros.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "pump");
  ros::NodeHandle nh;
  ros::Timer timer = nh.createTimer(ros::Duration(0.1), [](const ros::TimerEvent&) {}, false, false);
  timer.start();
  ros::spin();
}
