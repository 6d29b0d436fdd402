// Reads with short and long queues; those of `parts_long` are remapped to the same topic.
// expect: subscriber parts_long
#include <ros/ros.h>
#include <std_msgs/String.h>

void onText(const std_msgs::String&) {}

int main(int argc, char** argv) {
  ros::init(argc, argv, "viewer");
  ros::NodeHandle nh;
  ros::Subscriber parts_sub = nh.subscribe("parts", 2, onText);
  ros::Subscriber long_sub = nh.subscribe("parts_long", 3, onText);
  ros::Subscriber objects_sub = nh.subscribe("objects", 1, onText);
  ros::Subscriber many_sub = nh.subscribe("many", 10, onText);
  ros::Subscriber paced_sub = nh.subscribe("paced", 1, onText);
  ros::Subscriber either_sub = nh.subscribe("either", 1, onText);
  ros::spin();
}
