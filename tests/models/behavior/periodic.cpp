// Periodic sending: rates, timers, sleeps, parameters, own threads, and a loop that is not timed.
#include <unistd.h>
#include <thread>
#include <chrono>
#include <ros/ros.h>
#include <std_msgs/Bool.h>

ros::Publisher a, b, c, d, e;
bool g_quit = false;
std_msgs::Bool msg;

void thread_loop()
{
  while (!g_quit)
  {
    b.publish(msg);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}
void forever()
{
  for (;;)
  {
    if (msg.data)
      continue;
    c.publish(msg);
    usleep(250000);
  }
}
void busy()
{
  while (true)
    e.publish(msg);
}
void onTimer(const ros::TimerEvent&) { d.publish(msg); }
void onOnce(const ros::TimerEvent&) { e.publish(msg); }

int main(int argc, char** argv)
{
  ros::init(argc, argv, "n");
  ros::NodeHandle nh, pnh("~");
  a = nh.advertise<std_msgs::Bool>("a", 1);
  b = nh.advertise<std_msgs::Bool>("b", 1);
  c = nh.advertise<std_msgs::Bool>("c", 1);
  d = nh.advertise<std_msgs::Bool>("d", 1);
  e = nh.advertise<std_msgs::Bool>("e", 1);
  double hz;
  pnh.param("rate", hz, 40.0);
  std::thread first(thread_loop), second(forever), third(busy);
  ros::Timer timer = nh.createTimer(ros::Duration(1.0 / hz), onTimer);
  ros::Timer once = nh.createTimer(ros::Duration(5.0), onOnce, true);
  ros::Rate rate(hz);
  while (ros::ok())
  {
    a.publish(msg);
    ros::spinOnce();
    rate.sleep();
  }
}
// expect: periodic rate 40.0 ~rate a []
// expect: periodic sleep 50.0 None b []
// expect: periodic sleep 4.0 None c [!msg.data]
// expect: periodic timer 40.0 ~rate d []
// expect: once after 5.0 None -> e must []
