// expect-not: finding library-* "/sound*"
// expect-not: finding period-of-zero "/sound*"
// expect: component sound package=beginnings_ros1
#include <memory>
#include <ros/ros.h>
#include <std_msgs/String.h>
std::unique_ptr<ros::NodeHandle> handle;
struct Talker { ros::NodeHandle nh_; };
int main(int argc, char **argv) {
  ros::init(argc, argv, "sound");
  handle.reset(new ros::NodeHandle());
  Talker talker;
  int hz = 10;
  ros::Timer timer = handle->createTimer(ros::Duration(1.0 / hz), [](const ros::TimerEvent &) {});
  ros::Timer slow = handle->createTimer(ros::Duration(20 / hz), [](const ros::TimerEvent &) {});
  ros::Rate rate(10);
  while (ros::ok()) { ros::spinOnce(); rate.sleep(); }
}
