// Threads that a function waits for while it has a lock, beside some that it leaves running, and some that it waits for without one.
//
// expect-not: changed_at_once(V, _, _), variable_name(V, "g_kept")
// expect: changed_at_once(V, _, _), variable_name(V, "g_free")
// expect: changed_at_once(V, _, _), variable_name(V, "g_left")
#include <mutex>
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <thread>

std::mutex g_mutex;
int g_kept = 0;
int g_free = 0;
int g_left = 0;
ros::Publisher g_pub;

void onIn(const std_msgs::Int32& message)
{
  if (g_kept > 1 || g_free > 1 || g_left > 1)
    g_pub.publish(message);
}

void readAll()
{
  g_mutex.lock();
  {
    std::thread kept([&]() { g_kept = 1; });
    kept.join();
  }
  std::thread left([&]() { g_left = 1; });
  left.detach();
  g_mutex.unlock();
}

void writeAll()
{
  g_mutex.lock();
  std::thread kept([&]() { g_kept = 2; });
  std::thread left([&]() { g_left = 2; });
  kept.join();
  left.detach();
  g_mutex.unlock();
}

void free()
{
  std::thread one([&]() { g_free = 1; });
  std::thread other([&]() { g_free = 2; });
  one.join();
  other.join();
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "waiting");
  ros::NodeHandle nh;
  g_pub = nh.advertise<std_msgs::Int32>("out", 1);
  ros::Subscriber in = nh.subscribe("in", 1, onIn);
  ros::Rate rate(10);
  while (ros::ok()) {
    readAll();
    writeAll();
    free();
    ros::spinOnce();
    rate.sleep();
  }
}
