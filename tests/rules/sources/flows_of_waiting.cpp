// What comes after a wait is done only when what is waited for has come: a condition variable and what is asked meanwhile, a loop that
// waits, a way out of one. What is done before the wait does not hang on it, nor what another thread does.
//
// expect: port_flow([_, _, "/job"], [_, _, "/work"], "control", _)
// expect: port_flow([_, _, "/job"], [_, _, "/deep"], "control", _)
// expect: port_flow([_, _, "/signal"], [_, _, "/signalled"], "control", _)
// expect: port_flow([_, _, "/ready"], [_, _, "/started"], "control", _)
// expect: port_flow([_, _, "/way_out"], [_, _, "/out"], "control", _)
// expect-not: port_flow([_, _, "/job"], [_, _, "/before"], _, _)
// expect-not: port_flow([_, _, "/ready"], [_, _, "/work"], _, _)
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Empty.h>
#include <condition_variable>
#include <mutex>
#include <queue>
#include <thread>

std::mutex g_mutex;
std::condition_variable g_cond, g_signal;
std::queue<int> g_jobs;
bool g_ready = false;
bool g_way_out = false;
ros::Publisher g_before, g_work, g_deep, g_signalled, g_started, g_out;

void onJob(const std_msgs::Empty&)
{
  std::lock_guard<std::mutex> lock(g_mutex);
  g_jobs.push(1);
}

void onSignal(const std_msgs::Empty&) { g_signal.notify_one(); }
void onReady(const std_msgs::Bool& msg) { g_ready = msg.data; }
void onWayOut(const std_msgs::Bool& msg) { g_way_out = msg.data; }

void goDeep() { g_deep.publish(std_msgs::Empty()); }

void work()
{
  while (ros::ok())
  {
    std::unique_lock<std::mutex> lock(g_mutex);
    g_cond.wait(lock, [] { return !g_jobs.empty(); });
    g_jobs.pop();
    g_work.publish(std_msgs::Empty());
    goDeep();
  }
}

void wait()
{
  std::unique_lock<std::mutex> lock(g_mutex);
  g_before.publish(std_msgs::Empty());
  g_signal.wait(lock);
}

void signalled()
{
  while (ros::ok())
  {
    wait();
    g_signalled.publish(std_msgs::Empty());
  }
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_before = nh.advertise<std_msgs::Empty>("/before", 1);
  g_work = nh.advertise<std_msgs::Empty>("/work", 1);
  g_deep = nh.advertise<std_msgs::Empty>("/deep", 1);
  g_signalled = nh.advertise<std_msgs::Empty>("/signalled", 1);
  g_started = nh.advertise<std_msgs::Empty>("/started", 1);
  g_out = nh.advertise<std_msgs::Empty>("/out", 1);
  ros::Subscriber job = nh.subscribe("/job", 1, onJob);
  ros::Subscriber signal = nh.subscribe("/signal", 1, onSignal);
  ros::Subscriber ready = nh.subscribe("/ready", 1, onReady);
  ros::Subscriber way_out = nh.subscribe("/way_out", 1, onWayOut);
  std::thread worker(work), other(signalled);
  ros::Rate rate(10);
  while (ros::ok() && !g_ready)
  {
    ros::spinOnce();
    rate.sleep();
  }
  g_started.publish(std_msgs::Empty());
  while (ros::ok())
  {
    ros::spinOnce();
    if (g_way_out)
      break;
    rate.sleep();
  }
  g_out.publish(std_msgs::Empty());
  ros::spin();
}
