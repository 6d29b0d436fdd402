// A spinner that is started.
//
// expect-not: never_spun(_)
// expect: subscriber level
#include <ros/ros.h>
#include <std_msgs/Int32.h>

void onLevel(const std_msgs::Int32&) {}

int main(int argc, char** argv) {
  ros::init(argc, argv, "level");
  ros::NodeHandle nh;
  ros::Subscriber sub = nh.subscribe("level", 1, onLevel);
  ros::AsyncSpinner spinner(1);
  spinner.start();
  ros::waitForShutdown();
}
