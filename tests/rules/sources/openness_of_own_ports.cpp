// A library that makes ports in the node of the program without being given it.
//
// expect: 1 = count : { unseen("ports", _, _, _, _, _) }
// expect: unseen("ports", "makes", "moveit::planning_interface::MoveGroupInterface", _, 12, _)
#include <moveit/move_group_interface/move_group_interface.h>
#include <ros/ros.h>
#include <tuning/shape.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "planner");
  ros::NodeHandle nh;
  moveit::planning_interface::MoveGroupInterface arm("arm");
  tuning::Shape shape("round");
  arm.move();
  ros::spin();
}
