// Numbers in names: counters of loops that are known, and what is counted in other ways.
//
// expect: subscriber /up_0
// expect: subscriber /up_1
// expect-not: subscriber /up_2
// expect: subscriber /until_0
// expect: subscriber /until_1
// expect-not: subscriber /until_2
// expect: subscriber ?
// expect: periodic /half 2 Hz
// expect: N = count : { _counts_to(_, _) }, N = 2
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <string>

ros::Publisher g_pub;
ros::Subscriber g_sub[8];

void onMessage(const std_msgs::Empty&)
{
}

void onTimer(const ros::TimerEvent&)
{
  g_pub.publish(std_msgs::Empty());
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  const int count = 2;
  for (int i = 0; i < count; ++i)
    g_sub[i] = nh.subscribe("/up_" + std::to_string(i), 1, onMessage);
  for (int i = 0; i != 2; ++i)
    g_sub[2 + i] = nh.subscribe("/until_" + std::to_string(i), 1, onMessage);
  for (int i = 5; i > 0; --i)
    g_sub[i] = nh.subscribe(std::to_string(i), 1, onMessage);
  g_pub = nh.advertise<std_msgs::Empty>("/half", 1);
  double period = 1.0;
  ros::Timer timer = nh.createTimer(ros::Duration(period / 2), onTimer);
  ros::spin();
}
