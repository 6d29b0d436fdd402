// The frame of a message that a pointer holds.
//
// expect: sent_in_frame(_, [_, _, "scan"], "laser", "")
#include <boost/make_shared.hpp>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>

ros::Publisher pub;

void onTimer(const ros::TimerEvent&) {
  sensor_msgs::LaserScan::Ptr scan = boost::make_shared<sensor_msgs::LaserScan>();
  scan->header.frame_id = "laser";
  pub.publish(*scan);
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "lidar");
  ros::NodeHandle nh;
  pub = nh.advertise<sensor_msgs::LaserScan>("scan", 1);
  ros::Timer timer = nh.createTimer(ros::Duration(0.1), onTimer);
  ros::spin();
}
