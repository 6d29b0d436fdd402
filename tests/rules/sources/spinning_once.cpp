// What is due runs once: the program has no loop for it.
//
// expect: 1 = count : { runs_too_little(_, "once") }
#include <ros/ros.h>
#include <std_msgs/Int32.h>

void onLevel(const std_msgs::Int32&) {}

int main(int argc, char** argv) {
  ros::init(argc, argv, "level");
  ros::NodeHandle nh;
  ros::Subscriber sub = nh.subscribe("level", 1, onLevel);
  ros::spinOnce();
  ros::Rate rate(10);
  while (ros::ok()) rate.sleep();
}
