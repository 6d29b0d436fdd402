// Waiting in all units and classes, loops with all forms of endless conditions, timers whose period changes, and loops that are not timed.
#include <time.h>
#include <unistd.h>
#include <chrono>
#include <thread>
#include <boost/thread.hpp>
#include <ros/ros.h>
#include <std_msgs/Bool.h>

ros::Publisher a, b, c, d, e, f, g, h;
std_msgs::Bool msg;
volatile bool g_quit = false;
ros::Timer timer;

void nano()
{
  struct timespec pause = { 0, 500000000 };
  do
  {
    a.publish(msg);
    nanosleep(&pause, NULL);
  } while (!g_quit);
}
void posix()
{
  while (!ros::isShuttingDown())
  {
    b.publish(msg);
    boost::this_thread::sleep(boost::posix_time::milliseconds(100));
  }
}
void chrono()
{
  for (;;)
  {
    c.publish(msg);
    std::this_thread::sleep_for(std::chrono::microseconds(2000));
  }
}
void wall()
{
  ros::WallRate rate(ros::Duration(0.2));
  ros::NodeHandle nh;
  while (nh.ok())
  {
    d.publish(msg);
    rate.sleep();
  }
}
void seconds()
{
  while (1)
  {
    e.publish(msg);
    sleep(2);
  }
}
void stepwise()
{
  for (int i = 0; i < 10; ++i)
  {
    h.publish(msg);
    ros::Duration(0.1).sleep();
  }
}
void onTimer(const ros::TimerEvent&) { f.publish(msg); }
void onSlow(const std_msgs::Bool&) { timer.setPeriod(ros::Duration(10.0)); }

int main(int argc, char** argv)
{
  ros::init(argc, argv, "n");
  ros::NodeHandle nh;
  a = nh.advertise<std_msgs::Bool>("a", 1);
  b = nh.advertise<std_msgs::Bool>("b", 1);
  c = nh.advertise<std_msgs::Bool>("c", 1);
  d = nh.advertise<std_msgs::Bool>("d", 1);
  e = nh.advertise<std_msgs::Bool>("e", 1);
  f = nh.advertise<std_msgs::Bool>("f", 1);
  g = nh.advertise<std_msgs::Bool>("g", 1);
  h = nh.advertise<std_msgs::Bool>("h", 1);
  ros::Subscriber s = nh.subscribe("slow", 1, onSlow);
  std::thread t1(nano), t2(posix), t3(chrono), t4(wall), t5(seconds), t6(stepwise);
  timer = nh.createTimer(ros::Duration(1.0), onTimer);
  const double frequency = 25;
  ros::Rate rate(frequency);
  while (ros::ok() && !g_quit)
  {
    ros::spinOnce();
    if (!rate.sleep())
      continue;
    g.publish(msg);
  }
}
// expect: periodic sleep 2.0 None a []
// expect: periodic sleep 10.0 None b []
// expect: periodic sleep 500.0 None c []
// expect: periodic rate 5.0 None d []
// expect: periodic sleep 0.5 None e []
// expect: periodic timer 0.1 None f []
// expect: periodic timer 1.0 None f []
// expect: periodic rate 25.0 None g [!(!rate.sleep())]
