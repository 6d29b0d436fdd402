// That something arrives is all that matters; and what nobody uses goes nowhere.
//
// expect: port_flow([_, _, "/ping"], [_, _, "/pong"], "control", "reactive")
// expect: flow_always([_, _, "/ping"], [_, _, "/pong"], "reactive")
// expect: answers_most([_, _, "/ping"], [_, _, "/pong"], "1")
// expect: Count = count : { port_flow(_, _, _, _) }, Count = 1
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <std_msgs/Int32.h>

ros::Publisher pub;
int seen;

void onPing(const std_msgs::Int32&)
{
  std_msgs::Empty pong;
  pub.publish(pong);
}

void onNoise(const std_msgs::Int32& noise)
{
  seen = noise.data;
  ROS_INFO("noise %d", seen);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "ping");
  ros::NodeHandle nh;
  pub = nh.advertise<std_msgs::Empty>("/pong", 1);
  ros::Subscriber ping = nh.subscribe("/ping", 1, onPing), noise = nh.subscribe("/noise", 1, onNoise);
  ros::spin();
}
