// A name that is made where none is given: at the port it is never empty, whatever callers give.
//
// expect: publisher ?/pose
// expect: publisher spare/state
// expect: publisher ? from_param=~report unknown="named by parameter ~report"
// expect-only: publisher
#include <ros/ros.h>
#include <sstream>
#include <std_msgs/Empty.h>
#include <string>

ros::Publisher pose, state, reports;
int made = 0;

void spawn(const std::string & name)
{
  std::string real = name;
  if (real.empty()) {
    std::stringstream stream;
    stream << "turtle" << ++made;
    real = stream.str();
  }
  pose = ros::NodeHandle(real).advertise<std_msgs::Empty>("pose", 1);
}

void keep(const std::string & name)
{
  std::string real = name;
  if (real == "") {
    real = "spare";
  }
  state = ros::NodeHandle(real).advertise<std_msgs::Empty>("state", 1);
}

void report()
{
  std::string topic;
  ros::NodeHandle("~").param<std::string>("report", topic, "");
  if (!topic.empty()) {
    reports = ros::NodeHandle().advertise<std_msgs::Empty>(topic, 1);
  }
}

int main(int argc, char ** argv)
{
  ros::init(argc, argv, "empty");
  spawn("");
  keep("");
  report();
  ros::spin();
}
