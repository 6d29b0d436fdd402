// How long a loop waits, or a timer: by every way to say it.
//
// expect: periodic /seconds 0.5 Hz mechanism=sleep
// expect: periodic /micro 20 Hz mechanism=sleep
// expect: periodic /nano 4 Hz mechanism=sleep
// expect: periodic /chrono 10 Hz mechanism=sleep
// expect: periodic /chrono_rate 5 Hz mechanism=rate
// expect: periodic /timer 8 Hz mechanism=timer
// expect: periodic /reset 2 Hz mechanism=timer
#include <chrono>
#include <ctime>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <thread>
#include <unistd.h>

ros::Publisher g_seconds_pub, g_micro_pub, g_nano_pub, g_chrono_pub, g_rate_pub, g_timer_pub, g_reset_pub;

void seconds()
{
  while (ros::ok())
  {
    g_seconds_pub.publish(std_msgs::Empty());
    sleep(2);
  }
}

void micro()
{
  while (ros::ok())
  {
    g_micro_pub.publish(std_msgs::Empty());
    usleep(50000);
  }
}

void nano()
{
  timespec period;
  period.tv_sec = 0;
  period.tv_nsec = 250000000;
  while (ros::ok())
  {
    g_nano_pub.publish(std_msgs::Empty());
    nanosleep(&period, nullptr);
  }
}

void chrono()
{
  while (ros::ok())
  {
    g_chrono_pub.publish(std_msgs::Empty());
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}

void rateOfTime()
{
  ros::Rate rate(ros::Duration(0.2));
  while (ros::ok())
  {
    g_rate_pub.publish(std_msgs::Empty());
    rate.sleep();
  }
}

void onTimer(const ros::TimerEvent&)
{
  g_timer_pub.publish(std_msgs::Empty());
}

void onReset(const ros::TimerEvent&)
{
  g_reset_pub.publish(std_msgs::Empty());
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_seconds_pub = nh.advertise<std_msgs::Empty>("/seconds", 1);
  g_micro_pub = nh.advertise<std_msgs::Empty>("/micro", 1);
  g_nano_pub = nh.advertise<std_msgs::Empty>("/nano", 1);
  g_chrono_pub = nh.advertise<std_msgs::Empty>("/chrono", 1);
  g_rate_pub = nh.advertise<std_msgs::Empty>("/chrono_rate", 1);
  g_timer_pub = nh.advertise<std_msgs::Empty>("/timer", 1);
  g_reset_pub = nh.advertise<std_msgs::Empty>("/reset", 1);
  std::thread threads[] = {std::thread(seconds), std::thread(micro), std::thread(nano), std::thread(chrono), std::thread(rateOfTime)};
  ros::Timer timer = nh.createTimer(ros::Duration(0.125), onTimer);
  ros::Timer reset = nh.createTimer(ros::Duration(1.0), onReset);
  reset.setPeriod(ros::Duration(0.5));
  ros::spin();
}
