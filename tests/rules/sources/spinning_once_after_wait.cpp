// A program that waits for one message, and takes it.
//
// expect: 0 = count : { runs_too_little(_, _) }
#include <ros/ros.h>
#include <std_msgs/Int32.h>

void onLevel(const std_msgs::Int32&) {}

int main(int argc, char** argv) {
  ros::init(argc, argv, "level");
  ros::NodeHandle nh;
  ros::Subscriber sub = nh.subscribe("level", 1, onLevel);
  ros::Duration(1).sleep();
  ros::spinOnce();
}
