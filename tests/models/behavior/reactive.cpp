// Reactive sending: early returns, loops, try and catch, helper functions, keyed containers, ports given to functions.
#include <map>
#include <string>
#include <vector>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Int32.h>

ros::Publisher pub;
std::map<std::string, ros::Publisher> pubs;
bool parse(int);

void early(const std_msgs::Int32& m)
{
  if (m.data < 0)
    return;
  pub.publish(m);
}
void always(const std_msgs::Int32& m)
{
  if (m.data < 0)
    pub.publish(m);
  else
    pub.publish(m);
}
void looped(const std_msgs::Int32& m)
{
  for (int i = 0; i < m.data; ++i)
    pub.publish(m);
}
void skipping(const std_msgs::Int32& m)
{
  for (int i = 0; i < m.data; ++i)
  {
    if (i % 2)
      continue;
    pub.publish(m);
  }
}
void catching(const std_msgs::Int32& m)
{
  try
  {
    parse(m.data);
  }
  catch (const std::exception&)
  {
    return;
  }
  pub.publish(m);
}
void send(ros::Publisher& p, const std_msgs::Int32& m) { p.publish(m); }
void given(const std_msgs::Int32& m) { send(pubs["a"], m); }
void keyed(const std_msgs::Int32& m)
{
  switch (m.data)
  {
    case 1:
    case 2:
      pubs["b"].publish(m);
      break;
    default:
      break;
  }
}
void countdown(int n, const std_msgs::Int32& m)
{
  if (n > 0)
    countdown(n - 1, m);
  else
    pub.publish(m);
}
void recursive(const std_msgs::Int32& m) { countdown(m.data, m); }
void silent(const std_msgs::Int32&) {}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "n");
  ros::NodeHandle nh;
  pub = nh.advertise<std_msgs::Int32>("out", 1);
  pubs["a"] = nh.advertise<std_msgs::Int32>("a", 1);
  pubs["b"] = nh.advertise<std_msgs::Int32>("b", 1);
  ros::Subscriber s0 = nh.subscribe("early", 1, early);
  ros::Subscriber s1 = nh.subscribe("always", 1, always);
  ros::Subscriber s2 = nh.subscribe("looped", 1, looped);
  ros::Subscriber s3 = nh.subscribe("skipping", 1, skipping);
  ros::Subscriber s4 = nh.subscribe("catching", 1, catching);
  ros::Subscriber s5 = nh.subscribe("given", 1, given);
  ros::Subscriber s6 = nh.subscribe("keyed", 1, keyed);
  ros::Subscriber s7 = nh.subscribe("recursive", 1, recursive);
  ros::Subscriber s8 = nh.subscribe("silent", 1, silent);
  ros::spin();
}
// expect: reactive early -> out may [!(m.data < 0)]
// expect: reactive always -> out must []
// expect: reactive looped -> out may [i < m.data]
// expect: reactive skipping -> out may [i < m.data && !(i % 2)]
// expect: reactive catching -> out may []
// expect: reactive given -> a must []
// expect: reactive keyed -> b may [m.data == 1 || m.data == 2]
// expect: reactive recursive -> out must [!(n > 0)]
