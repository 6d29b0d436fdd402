// Recursion terminates; what it makes of a name is unknown.
#include <string>

#include <ros/ros.h>
#include <std_msgs/String.h>

typedef std_msgs::String M;

std::string path(int n)
{
  return n ? path(n - 1) + "/x" : "root";
}

void spread(ros::NodeHandle& nh, std::string topic, int n)
{
  if (n)
    spread(nh, topic + topic, n - 1);
  nh.advertise<M>(topic, 1);  // expect: publisher a
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "recursion");
  ros::NodeHandle nh;
  nh.advertise<M>(path(argc), 1);  // expect: publisher root
  // expect: publisher ?
  spread(nh, "a", 3);
}
