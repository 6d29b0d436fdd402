// What a variable gets when the call that reads its parameter tells that there is none, and what it, or another one, gets otherwise.
//
// expect: param ~rate = 5
// expect: param ~size = 4
// expect: param ~side
// expect: param ~none op=has
// expect-only: param
// expect: 2 = count : { fallback(_, _, _) }, 2 = count : { has_fallback(_) }, 3 = count : { read_into(_, _) }
#include <ros/ros.h>
#include <string>

bool g_fast = false;

void warn(int rate)
{
  ROS_WARN("%d", rate);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "fallbacks");
  ros::NodeHandle nh("~");
  int rate, size, side, other = 0;
  if (!nh.getParam("rate", rate))
  {
    rate = 5;
    other = 7;
    other += rate;
    warn(rate);
  }
  if (nh.getParam("size", size))
  {
    size = 3;
    other = 8;
  }
  else
    size = 4;
  nh.getParam("side", side);
  if (g_fast)
    side = 9;
  if (!g_fast)
    rate = 10;
  bool known = nh.hasParam("none");
  if (!known)
    other = 11;
  else
    other = 12;
  warn(rate + size + side + other);
  ros::spin();
}
