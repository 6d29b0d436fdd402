#include <string>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

#include "tunable_robot/pairing.h"

struct OutputNames
{
  static constexpr const char* first = "paired/image";
  static std::string second()
  {
    return "paired/scan";
  }
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "pairing");
  Pairing<sensor_msgs::Image, sensor_msgs::LaserScan, OutputNames> pairing("raw");
  pairing.run();
  return 0;
}
