// Headers of messages that their package defines, and that it does not.
// expect-not: finding unknown-interface "*Meal*"
// expect-not: finding unknown-interface "*made_msgs*"
#include <kitchen_msgs/Meal.h>
#include <kitchen_msgs/Menu.h>  // expect: finding unknown-interface "/oven needs the header kitchen_msgs/Menu.h, which kitchen_msgs does not define"
#include <made_msgs/MadeByProgram.h>
#include <ros/ros.h>

int main(int argc, char** argv) {
  ros::init(argc, argv, "oven");
  ros::NodeHandle nh;
  ros::Publisher pub = nh.advertise<kitchen_msgs::Meal>("meal", 1);
  ros::spin();
}
