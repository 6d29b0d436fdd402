// The body of a function that the compiler loses: at each line of it that makes ports they are told as open, by their text.
//
// expect: 3 = count : { unseen("ports", "lost", _, _, _, _) }
// expect: unseen("ports", "lost", _, _, 13, _)
// expect: unseen("ports", "lost", _, _, 15, _)
// expect: unseen("ports", "lost", _, _, 17, _)
// expect: 1 = count : { unseen("params", "lost", _, _, _, _) }
#include <ros/ros.h>
#include <std_msgs/Empty.h>

typedef int Driver;

void Driver::start(ros::NodeHandle& nh) {
  // nh.advertise<std_msgs::Empty>("out", 1);
  pub_ = nh.advertise<std_msgs::Empty>("in", 1);
  count(pub_);
  server_ = nh.advertiseService("stop", &Driver::onStop, this);
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "driver");
  ros::NodeHandle nh;
  ros::spin();
}
