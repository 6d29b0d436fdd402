#include <string>

#include <ros/ros.h>

template <class T>
void getOrKeep(ros::NodeHandle& nh, const std::string& name, T& value)
{
  if (!nh.getParam(name, value))
  {
    ROS_WARN("%s is not set", name.c_str());
  }
}

template <class T>
void getOrDefault(ros::NodeHandle& nh, const std::string& name, T& value, const T& otherwise)
{
  if (!nh.getParam(name, value))
  {
    value = otherwise;
  }
}

bool readNumber(const ros::NodeHandle& nh, const char* name, double* number, double otherwise)
{
  return nh.param(name, *number, otherwise);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "gains");
  ros::NodeHandle nh("~");

  double p = 0.5;
  std::string frame = "base_link";
  getOrKeep(nh, "p", p);
  getOrKeep(nh, "frame", frame);

  int order;
  bool clamp;
  getOrDefault(nh, "order", order, 2);
  getOrDefault(nh, "clamp", clamp, true);

  double i, d;
  readNumber(nh, "i", &i, 0.25);
  if (nh.getParam("d", d))
  {
    ROS_INFO("d is %f", d);
  }
  else
  {
    d = 0.125;
  }

  ros::spin();
  return 0;
}
