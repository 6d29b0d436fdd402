// A thread beside the callbacks: what both change, unless both take a lock, give the same constant, or the variable is atomic.
//
// expect: Count = count : { changed_at_once(V, E, D), variable_name(V, "g_count") }, Count = 2
// expect-not: changed_at_once(V, _, _), variable_name(V, "g_locked")
// expect-not: changed_at_once(V, _, _), variable_name(V, "g_flag")
// expect-not: changed_at_once(V, _, _), variable_name(V, "g_atomic")
// expect: concurrent(F, G), function_name(F, "onIn"), function_name(G, "work")
// expect: concurrent(F, G), function_name(F, "work"), function_name(G, "onIn")
// expect-not: concurrent(F, F)
// expect-not: concurrent(F, G), function_name(F, "onIn"), function_name(G, "onLocked")
// expect: Count = count : { locks(_) }, Count = 3
// expect: locks(F), function_name(F, "takeGuarded")
#include <atomic>
#include <mutex>
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <thread>

std::mutex g_mutex;
int g_count = 0;
int g_locked = 0;
bool g_flag = false;
std::atomic<int> g_atomic{0};
ros::Publisher g_pub;

void send(const std_msgs::Int32& message)
{
  if (g_count > 1)
    g_pub.publish(message);
  if (g_locked > 1)
    g_pub.publish(message);
  if (g_flag)
    g_pub.publish(message);
  if (g_atomic > 1)
    g_pub.publish(message);
}

void onIn(const std_msgs::Int32& message)
{
  g_count = message.data;
  g_flag = true;
  g_atomic = message.data;
  send(message);
}

void onLocked(const std_msgs::Int32& message)
{
  std::lock_guard<std::mutex> lock(g_mutex);
  g_locked = message.data;
}

void takeGuarded()
{
  std::unique_lock<std::mutex> lock(g_mutex);
  g_locked = 0;
}

void work()
{
  g_count = 0;
  g_flag = true;
  g_atomic = 1;
}

void workLocked()
{
  takeGuarded();
}

void workLoop()
{
  ros::Rate rate(10);
  while (ros::ok())
  {
    g_mutex.lock();
    g_locked = 7;
    g_mutex.unlock();
    rate.sleep();
  }
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_pub = nh.advertise<std_msgs::Int32>("/out", 1);
  ros::Subscriber in_sub = nh.subscribe("/in", 1, onIn);
  ros::Subscriber locked_sub = nh.subscribe("/locked", 1, onLocked);
  std::thread worker(work), locked_worker(workLocked), looping(workLoop);
  ros::spin();
}
