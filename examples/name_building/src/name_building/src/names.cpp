#include <array>
#include <cstdio>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <boost/format.hpp>
#include <boost/lexical_cast.hpp>
#include <ros/ros.h>
#include <std_msgs/Float64.h>

namespace
{
const char* const WHEELS[] = { "wheel/front", "wheel/rear" };
constexpr const char* BATTERY = "battery";
const std::string PREFIX = "arm_";

struct Channel
{
  std::string topic;
  int queue;
};

std::vector<ros::Publisher> publishers;

void advertise(ros::NodeHandle& nh, const std::string& name, int queue = 7)
{
  publishers.push_back(nh.advertise<std_msgs::Float64>(name, queue));
}

void advertiseBoth(ros::NodeHandle& nh, const std::string& side)
{
  advertise(nh, side + "/speed", 3);
  advertise(nh, side + "/torque");
}

void byReference(std::string& name)
{
  name = "by_reference";
}

void byPointer(std::string* name)
{
  *name = "by_pointer";
}

std::string nested(int depth)
{
  return depth == 0 ? "leaf" : nested(depth - 1) + "/branch";
}
}  // namespace

int main(int argc, char** argv)
{
  ros::init(argc, argv, "names");
  ros::NodeHandle nh;

  for (const char* wheel : WHEELS)
  {
    advertise(nh, wheel, 1);
  }
  advertise(nh, BATTERY, 2);
  advertise(nh, PREFIX + "left", 2);
  advertiseBoth(nh, "starboard");
  advertiseBoth(nh, "port");

  std::string out, through;
  byReference(out);
  byPointer(&through);
  publishers.push_back(nh.advertise<std_msgs::Float64>(out, 1));
  publishers.push_back(nh.advertise<std_msgs::Float64>(through, 1));

  std::string grown = "gr";
  grown += "ow";
  grown.append("n");
  publishers.push_back(nh.advertise<std_msgs::Float64>(grown.c_str(), 2 * 5 + 1));

  for (int i = 0; i < 3; ++i)
  {
    std::ostringstream name;
    name << "sonar_" << i;
    publishers.push_back(nh.advertise<std_msgs::Float64>(name.str(), 1));
  }
  publishers.push_back(nh.advertise<std_msgs::Float64>((boost::format("cell_%1%_%2%") % "a" % 3).str(), 1));
  publishers.push_back(nh.advertise<std_msgs::Float64>("cell_" + std::to_string(4) + boost::lexical_cast<std::string>(5), 1));
  char text[32];
  snprintf(text, sizeof(text), "valve_%s_%d", "in", 6);
  publishers.push_back(nh.advertise<std_msgs::Float64>(text, 1));

  const std::map<std::string, int> tanks{ { "tank/fresh", 5 }, { "tank/waste", 5 } };
  for (const auto& tank : tanks)
  {
    publishers.push_back(nh.advertise<std_msgs::Float64>(tank.first, tank.second));
  }
  const std::vector<Channel> channels = { { "lamp", 4 }, { "horn", 4 } };
  for (const Channel& channel : channels)
  {
    publishers.push_back(nh.advertise<std_msgs::Float64>(channel.topic, channel.queue));
  }
  Channel spare = { "spare", 8 };
  publishers.push_back(nh.advertise<std_msgs::Float64>(spare.topic, spare.queue));
  std::array<std::string, 2> pumps = { { "pump/a", "pump/b" } };
  for (const std::string& pump : pumps)
  {
    publishers.push_back(nh.advertise<std_msgs::Float64>(pump, 1));
  }
  const std::pair<std::string, int> fan("fan", 9);
  publishers.push_back(nh.advertise<std_msgs::Float64>(fan.first, fan.second));

  std::string robot;
  if (!nh.getParam("robot", robot))
  {
    robot = "alpha";
  }
  publishers.push_back(nh.advertise<std_msgs::Float64>(robot + "/load", 1));
  publishers.push_back(nh.advertise<std_msgs::Float64>(argc > 1 ? "many" : "few", 1));
  publishers.push_back(nh.advertise<std_msgs::Float64>(std::string(argv[1]) + "/level", 1));
  publishers.push_back(nh.advertise<std_msgs::Float64>(nested(argc), 1));
  ros::spin();
  return 0;
}
