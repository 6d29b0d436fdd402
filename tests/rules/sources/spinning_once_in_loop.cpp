// What is due runs in every round: in the loop itself, or in a function that the loop calls.
//
// expect: 0 = count : { runs_too_little(_, _) }
#include <ros/ros.h>
#include <std_msgs/Int32.h>

void onLevel(const std_msgs::Int32&) {}

void step() { ros::spinOnce(); }

int main(int argc, char** argv) {
  ros::init(argc, argv, "level");
  ros::NodeHandle nh;
  ros::Subscriber sub = nh.subscribe("level", 1, onLevel);
  while (ros::ok()) step();
}
