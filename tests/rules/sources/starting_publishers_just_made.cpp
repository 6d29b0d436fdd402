// Publishers that a callback makes and publishes through at once.
//
// expect: sent_where_made([_, _, "alarm"], _)
// expect: 1 = count : { sent_where_made(_, _) }
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Float32.h>

ros::NodeHandle* handle;
ros::Publisher kept;
std::vector<ros::Publisher> all;

void onHeat(const std_msgs::Float32&) {
  ros::Publisher pub = handle->advertise<std_msgs::Bool>("alarm", 1);
  pub.publish(std_msgs::Bool());
}

void onCold(const std_msgs::Float32&) {
  ros::Publisher waited = handle->advertise<std_msgs::Bool>("waited", 1);
  while (waited.getNumSubscribers() == 0) ros::Duration(0.1).sleep();
  waited.publish(std_msgs::Bool());
}

void onWind(const std_msgs::Float32&) {
  kept = handle->advertise<std_msgs::Bool>("kept", 1);
  kept.publish(std_msgs::Bool());
  static ros::Publisher once = handle->advertise<std_msgs::Bool>("once", 1);
  once.publish(std_msgs::Bool());
}

void onRain(const std_msgs::Float32&) {
  ros::Publisher listed = handle->advertise<std_msgs::Bool>("listed", 1);
  listed.publish(std_msgs::Bool());
  all.push_back(listed);
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "guard");
  ros::NodeHandle nh;
  handle = &nh;
  ros::Publisher begun = nh.advertise<std_msgs::Bool>("begun", 1);
  begun.publish(std_msgs::Bool());
  ros::Subscriber heat = nh.subscribe("heat", 1, onHeat);
  ros::Subscriber cold = nh.subscribe("cold", 1, onCold);
  ros::Subscriber wind = nh.subscribe("wind", 1, onWind);
  ros::Subscriber rain = nh.subscribe("rain", 1, onRain);
  ros::spin();
}
