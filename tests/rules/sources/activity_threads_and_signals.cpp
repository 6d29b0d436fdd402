// What starts activities beside ports: a timer that runs once, a thread, a signal, functions that a library runs.
//
// expect: activity(F, "once"), function_name(F, "onTimeout")
// expect: activity(F, "thread"), function_name(F, "work")
// expect: activity(F, "signal"), function_name(F, "onSignal")
// expect: Count = count : { activity(Root, Kind) }, Count = 5
// expect: one_shot /late 2.5 s must
// expect: one_shot /maybe 2.5 s may
// expect-not: periodic /late
// expect: enters(_, F), function_name(F, "sendOne")
// expect: reactive /in -> /each may
// expect: state g_stop = false
// expect: transition g_stop = true
// expect-not: reactive /in -> /late
// expect: 6 = count : { concurrent(_, _) }
#include <algorithm>
#include <csignal>
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <thread>
#include <vector>

ros::Publisher g_late_pub, g_maybe_pub, g_each_pub, g_work_pub;
bool g_stop = false;
std::vector<int> g_numbers;

void onTimeout(const ros::TimerEvent&)
{
  g_late_pub.publish(std_msgs::Bool());
  if (g_stop)
    g_maybe_pub.publish(std_msgs::Bool());
}

void work()
{
  g_work_pub.publish(std_msgs::Bool());
}

void onSignal(int)
{
  g_stop = true;
}

void sendOne(int)
{
  g_each_pub.publish(std_msgs::Bool());
}

void onIn(const std_msgs::Bool&)
{
  std::for_each(g_numbers.begin(), g_numbers.end(), sendOne);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_late_pub = nh.advertise<std_msgs::Bool>("/late", 1);
  g_maybe_pub = nh.advertise<std_msgs::Bool>("/maybe", 1);
  g_each_pub = nh.advertise<std_msgs::Bool>("/each", 1);
  g_work_pub = nh.advertise<std_msgs::Bool>("/work", 1);
  signal(SIGINT, onSignal);
  std::thread worker(work);
  ros::Timer timer = nh.createTimer(ros::Duration(2.5), onTimeout, true);
  ros::Subscriber sub = nh.subscribe("/in", 1, onIn);
  ros::spin();
}
