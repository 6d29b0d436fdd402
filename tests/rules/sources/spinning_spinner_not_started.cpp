// A spinner that nothing starts runs no callbacks, whatever waits for the end.
//
// expect: 1 = count : { never_spun(_) }
#include <ros/ros.h>
#include <std_msgs/Int32.h>

void onLevel(const std_msgs::Int32&) {}

int main(int argc, char** argv) {
  ros::init(argc, argv, "level");
  ros::NodeHandle nh;
  ros::Subscriber sub = nh.subscribe("level", 1, onLevel);
  ros::AsyncSpinner spinner(1);
  ros::waitForShutdown();
}
