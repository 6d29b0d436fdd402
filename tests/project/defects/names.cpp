// Names that are no literal of the call: through a member, arguments, string building, a list, a parameter that is an out-argument.
// expect: Count = count : { port([_, "publisher", _]) }, Count = 8
#include <string>
#include <vector>

#include <ros/ros.h>
#include <std_msgs/String.h>

typedef std_msgs::String M;

struct Member
{
  std::string topic = "member";
  void go(ros::NodeHandle& nh) { nh.advertise<M>(topic, 1); }  // expect: publisher member
};

void argument(ros::NodeHandle& nh, std::string topic)
{
  nh.advertise<M>(topic, 1);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "names");
  ros::NodeHandle nh;
  Member member;
  member.go(nh);
  // expect: publisher first
  argument(nh, "first");
  // expect: publisher second
  argument(nh, "second");
  std::string built = "a";
  built += "b";
  nh.advertise<M>(built + "/c", 1);  // expect: publisher ab/c
  for (const std::string& listed : std::vector<std::string>{"one", "two"})
    nh.advertise<M>(listed, 1);  // expect: publisher one
  // expect: publisher two
  std::string read;
  nh.param<std::string>("topic", read, "scan");
  nh.advertise<M>(read, 1);  // expect: publisher scan from_param=topic
  nh.advertise<M>(ros::names::append("ns", "x"), 1);  // expect: publisher ns/x
}
