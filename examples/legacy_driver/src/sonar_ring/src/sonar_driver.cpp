#include <cstdio>
#include <sstream>
#include <string>

#include <ros/ros.h>
#include <sensor_msgs/Range.h>
#include <std_msgs/Bool.h>
#include <std_msgs/String.h>
#include <std_srvs/SetBool.h>

#include "protocol/sonar_bus.h"

#define NODE_NAME "sonars"
#define TOPIC_POWER "power"

static const char* SIDES[] = { "front", "left", "right", "rear" };
static const int NUM_SIDES = 4;

ros::Publisher range_pub;
ros::Publisher side_pub[NUM_SIDES];
ros::Publisher state_pub;

bool powered = true;
std::string frame_prefix;

void powerCallback(const std_msgs::Bool::ConstPtr& msg)
{
  powered = msg->data;
  bus_power(powered);
}

bool setPower(std_srvs::SetBool::Request& req, std_srvs::SetBool::Response& res)
{
  powered = req.data;
  bus_power(powered);
  res.success = true;
  return true;
}

void publishState(const char* text)
{
  std_msgs::String msg;
  msg.data = text;
  state_pub.publish(msg);
}

void setup(ros::NodeHandle& n)
{
  std::string prefix = "/";
  prefix += NODE_NAME;
  range_pub = n.advertise<sensor_msgs::Range>(prefix + "/range", 50);
  for (int i = 0; i < NUM_SIDES; ++i)
  {
    std::stringstream topic;
    topic << "range_" << SIDES[i];
    side_pub[i] = n.advertise<sensor_msgs::Range>(topic.str(), 10);
  }
  char state_topic[32];
  sprintf(state_topic, "%s_state", NODE_NAME);
  state_pub = n.advertise<std_msgs::String>(state_topic, 1, true);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, NODE_NAME, ros::init_options::AnonymousName);
  ros::NodeHandle n;
  ros::NodeHandle pn("~");

  std::string device;
  pn.param("device", device, std::string("/dev/sonar"));
  pn.param<std::string>("frame_prefix", frame_prefix, "");
  int hz = 10;
  if (pn.hasParam("rate"))
    pn.getParam("rate", hz);

  setup(n);
  ros::Subscriber power_sub = n.subscribe(TOPIC_POWER, 1, powerCallback);
  ros::ServiceServer power_srv = pn.advertiseService("set_power", setPower);

  if (bus_open(device.c_str()) != 0)
  {
    publishState("no bus");
    ROS_ERROR("cannot open %s", device.c_str());
    return -1;
  }
  publishState("running");

  ros::Rate loop_rate(hz);
  int side = 0;
  while (ros::ok())
  {
    if (powered)
    {
      sensor_msgs::Range msg;
      msg.header.stamp = ros::Time::now();
      msg.header.frame_id = frame_prefix + SIDES[side];
      msg.range = bus_ping(side);
      range_pub.publish(msg);
      side_pub[side].publish(msg);
      side = (side + 1) % NUM_SIDES;
    }
    ros::spinOnce();
    loop_rate.sleep();
  }
  pn.setParam("last_side", side);
  return 0;
}
