#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/Range.h>

void onRange(const sensor_msgs::Range::ConstPtr&)
{
}

// defined in a library that is not among the sources
void robotName(std::string& name);

int main(int argc, char** argv)
{
  ros::init(argc, argv, "sensors");
  ros::NodeHandle nh, private_nh("~");
  std::vector<ros::Subscriber> subscribers;

  // one word per sensor
  std::string list;
  private_nh.param<std::string>("sensors", list, "front rear");
  std::stringstream words(list);
  std::string sensor;
  while (words >> sensor)
  {
    subscribers.push_back(nh.subscribe(sensor, 1, onRange));
    ros::NodeHandle sensor_nh(nh, sensor);
    subscribers.push_back(sensor_nh.subscribe("range", 1, onRange));
    subscribers.push_back(nh.subscribe("array/" + sensor + "/raw", 1, onRange));
  }

  // texts that are changed in place
  std::string replaced = "sonar-left";
  std::replace(replaced.begin(), replaced.end(), '-', '_');
  subscribers.push_back(nh.subscribe(replaced, 2, onRange));
  std::string erased = "/sonar/right";
  erased.erase(0, 1);
  subscribers.push_back(nh.subscribe(erased, 2, onRange));
  std::string filled = "robot";
  robotName(filled);
  subscribers.push_back(nh.subscribe(filled + "/sonar", 2, onRange));
  std::string emptied = "old";
  emptied.clear();
  emptied += "sonar";
  emptied.push_back('/');
  subscribers.push_back(nh.subscribe(emptied + "rear", 2, onRange));

  // a stream that is asked twice
  std::ostringstream name;
  name << "sonar_" << 7;
  subscribers.push_back(nh.subscribe(name.str(), 3, onRange));
  subscribers.push_back(nh.subscribe(name.str() + "/calibrated", 3, onRange));

  ros::spin();
  return 0;
}
