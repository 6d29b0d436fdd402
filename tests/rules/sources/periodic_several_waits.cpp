// A loop that waits at several places is one: timed by the last of those that wait for the same time. What it sends is told once for each period.
//
// expect-only: periodic *
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <thread>

ros::Publisher g_continued_pub, g_slower_pub, g_unknown_pub, g_first_pub, g_second_pub;
bool g_ready;
double g_pause;

void continued()
{
  ros::Rate rate(10);
  while (ros::ok())
  {
    if (!g_ready)
    {
      ros::spinOnce();
      rate.sleep();  // expect-not: periodic /continued
      continue;
    }
    g_continued_pub.publish(std_msgs::Empty());
    rate.sleep();  // expect: periodic /continued 10 Hz mechanism=rate
  }
}

void slower()
{
  ros::Rate rate(20);
  while (ros::ok())
  {
    if (!g_ready)
    {
      ros::Duration(1.0).sleep();  // expect: periodic /slower 1 Hz mechanism=sleep
      continue;
    }
    g_slower_pub.publish(std_msgs::Empty());
    rate.sleep();  // expect: periodic /slower 20 Hz mechanism=rate
  }
}

void unknown()
{
  while (ros::ok())
  {
    if (!g_ready)
    {
      ros::Duration(g_pause).sleep();  // expect-not: periodic
      continue;
    }
    g_unknown_pub.publish(std_msgs::Empty());
    ros::Duration(g_pause).sleep();  // expect: periodic /unknown mechanism=sleep
  }
}

void first()
{
  while (ros::ok())
  {
    g_first_pub.publish(std_msgs::Empty());
    ros::Duration(0.5).sleep();  // expect: periodic /first 2 Hz mechanism=sleep
  }
  while (ros::ok())
  {
    g_second_pub.publish(std_msgs::Empty());
    ros::Duration(0.5).sleep();  // expect: periodic /second 2 Hz mechanism=sleep
  }
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_continued_pub = nh.advertise<std_msgs::Empty>("/continued", 1);
  g_slower_pub = nh.advertise<std_msgs::Empty>("/slower", 1);
  g_unknown_pub = nh.advertise<std_msgs::Empty>("/unknown", 1);
  g_first_pub = nh.advertise<std_msgs::Empty>("/first", 1);
  g_second_pub = nh.advertise<std_msgs::Empty>("/second", 1);
  nh.getParam("pause", g_pause);
  std::thread threads[] = {std::thread(continued), std::thread(slower), std::thread(unknown), std::thread(first)};
  ros::spin();
}
