// Rarer ways of texts: flags, choices by defaults, rates that are not known, functions that globals are made with.
//
// expect: N = count : { value(E, Context, "?", Parameter), wanted(E) }, N = 5
// expect: N = count : { entered_from(_, _, _) }, N = 2
// expect: N = count : { function_context(F, Context), function_defined(F) }, N = 5
// expect: N = count : { inserted(_, _, _) }, N = 1
// expect-only: subscriber
// expect: subscriber /of_global
// expect: subscriber /left
// expect: subscriber /right
// expect-not: constant_condition(_, _)
// expect-not: operand_values(_, _, _, _, _, _)
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>

const int LEFT = 1;
const int RIGHT = 2;

ros::Publisher g_pub;

void onMessage(const std_msgs::Empty&)
{
}

void onTimer(const ros::TimerEvent&)
{
  g_pub.publish(std_msgs::Empty());
}

ros::Subscriber make(const std::string& name)
{
  ros::NodeHandle nh;
  return nh.subscribe(name, 1, onMessage);
}

ros::Subscriber g_made = make("/of_global");
ros::Subscriber g_left, g_right;

void setup(ros::NodeHandle& nh, int sides)
{
  if (sides & LEFT)
    g_left = nh.subscribe("/left", 1, onMessage);
  if (sides & RIGHT)
    g_right = nh.subscribe("/right", 1, onMessage);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh, private_nh("~");
  int sides = LEFT;
  sides |= RIGHT;
  setup(nh, sides);
  bool real = private_nh.param("real", true);
  ros::Subscriber chosen = nh.subscribe(real ? "/real" : "/simulated", 1, onMessage);  // expect: subscriber /real
  g_pub = nh.advertise<std_msgs::Empty>("/timed", 1);
  double rate = atof(argv[1]);
  ros::Timer timer = nh.createTimer(ros::Duration(1.0 / rate), onTimer);  // expect: periodic /timed hz=
  ros::spin();
}
