// expect: sent_at_start /map 20
// expect: sent_in_a_row /parts 23
// expect: sent_at_start /parts 23
#include <ros/ros.h>
#include <std_msgs/String.h>

ros::Publisher status;

void onCommand(const std_msgs::String& message) { status.publish(message); }

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  ros::Publisher map = nh.advertise<std_msgs::String>("/map", 1);
  ros::Publisher parts = nh.advertise<std_msgs::String>("/parts", 1, true);
  status = nh.advertise<std_msgs::String>("/status", 1);
  ros::Subscriber sub = nh.subscribe("/command", 1, onCommand);
  std_msgs::String message;
  status.publish(message);
  map.publish(message);
  for (int i = 0; i < 3; ++i) {
    message.data = std::to_string(i);
    parts.publish(message);
  }
  ros::spin();
}
