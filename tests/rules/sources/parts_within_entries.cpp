// Entries of a map whose values are structures with texts of their own: the key of an entry is not what stands first in its value.
//
// expect: publisher sensors/voltage/info
// expect: publisher sensors/current/info
// expect-only: publisher
#include <map>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>

struct Sensor
{
  std::string name;
  std::string unit;
  ros::Publisher pub;
};

std::map<std::string, Sensor> g_sensors{
  {"voltage", {"Voltage of the battery", "V"}},
  {"current", {"Current of the motor", "A"}},
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  for (auto& entry : g_sensors) entry.second.pub = nh.advertise<std_msgs::Empty>("sensors/" + entry.first + "/info", 1);
  ros::spin();
}
