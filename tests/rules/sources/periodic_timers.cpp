// Timers of every make, and loops whose waits say nothing: how often they run, and what once.
//
// expect: periodic /plain 4 Hz mechanism=timer
// expect: periodic /number 2 Hz mechanism=timer
// expect: periodic /member 8 Hz mechanism=timer
// expect: periodic /listed 5 Hz mechanism=timer
// expect: periodic /steady 1 Hz mechanism=timer
// expect: periodic /brace 20 Hz mechanism=sleep
// expect: periodic /both mechanism=sleep hz=
// expect: periodic /rate 25 Hz mechanism=rate
// expect: periodic /member_rate 40 Hz mechanism=rate
// expect: periodic /helped 10 Hz mechanism=rate
// expect-only: periodic
// expect: one_shot /once 3 s must
// expect: one_shot /sometimes 3 s may if "g_level > 1"
// expect: one_shot /deep 3 s must
// expect-only: one_shot
// expect: Count = count : { period_amount(Site, Amount, PerSecond) }, Count = 13
// expect: Count = count : { timer_callback(C, F) }, Count = 7
// expect: Count = count : { one_shot(C) }, Count = 1
#include <chrono>
#include <ctime>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <thread>

ros::Publisher g_plain, g_number, g_brace, g_both, g_rate, g_helped, g_once, g_sometimes, g_deep, g_again;
int g_level = 0;

void onPlain(const ros::TimerEvent&)
{
  g_plain.publish(std_msgs::Empty());
}

void onNumber(const ros::TimerEvent&)
{
  g_number.publish(std_msgs::Empty());
}

void sendDeep()
{
  g_deep.publish(std_msgs::Empty());
}

void onOnce(const ros::TimerEvent&)
{
  g_once.publish(std_msgs::Empty());
  if (g_level > 1)
    g_sometimes.publish(std_msgs::Empty());
  sendDeep();
  g_level = 2;
}

// nobody makes a timer of it
void onNever(const ros::TimerEvent&)
{
  g_plain.publish(std_msgs::Empty());
}

class Node
{
public:
  explicit Node(ros::NodeHandle& nh)
    : listed_(nh.createTimer(ros::Duration(1.0), &Node::onListed, this)), rate_(40)
  {
    member_pub_ = nh.advertise<std_msgs::Empty>("/member", 1);
    listed_pub_ = nh.advertise<std_msgs::Empty>("/listed", 1);
    steady_pub_ = nh.advertise<std_msgs::Empty>("/steady", 1);
    rate_pub_ = nh.advertise<std_msgs::Empty>("/member_rate", 1);
    member_ = nh.createTimer(ros::Duration(1.0), &Node::onMember, this);
    member_.setPeriod(ros::Duration(0.125));
    listed_.setPeriod(ros::Duration(0.2));
    steady_ = nh.createSteadyTimer(ros::WallDuration(1.0), &Node::onSteady, this);
    steady_.stop();
  }

  void run()
  {
    while (ros::ok())
    {
      rate_pub_.publish(std_msgs::Empty());
      rate_.sleep();
    }
  }

private:
  void onMember(const ros::TimerEvent&)
  {
    member_pub_.publish(std_msgs::Empty());
  }

  void onListed(const ros::TimerEvent&)
  {
    listed_pub_.publish(std_msgs::Empty());
  }

  void onSteady(const ros::SteadyTimerEvent&)
  {
    steady_pub_.publish(std_msgs::Empty());
  }

  ros::Publisher member_pub_, listed_pub_, steady_pub_, rate_pub_;
  ros::Timer listed_, member_;
  ros::SteadyTimer steady_;
  ros::Rate rate_;
};

void brace()
{
  timespec period = {0, 50000000};
  while (ros::ok())
  {
    g_brace.publish(std_msgs::Empty());
    nanosleep(&period, nullptr);
  }
}

// seconds and parts of them: which rate that is, is not told
void both()
{
  timespec period;
  period.tv_sec = 1;
  period.tv_nsec = 500000000;
  while (ros::ok())
  {
    g_both.publish(std_msgs::Empty());
    nanosleep(&period, nullptr);
  }
}

void rate()
{
  ros::Rate rate(25), other(100);
  while (ros::ok())
  {
    g_rate.publish(std_msgs::Empty());
    rate.sleep();
  }
}

void wait(ros::Rate& rate)
{
  rate.sleep();
}

void helped()
{
  ros::Rate rate(10);
  while (ros::ok())
  {
    g_helped.publish(std_msgs::Empty());
    rate.sleep();
  }
}

// nobody calls it
void unused(ros::NodeHandle& nh)
{
  ros::Timer timer = nh.createTimer(ros::Duration(0.25), onNever);
  timer.setPeriod(ros::Duration(0.1));
  ros::Rate rate(77);
  while (ros::ok())
    rate.sleep();
  usleep(7);
  timespec period = {0, 7};
  nanosleep(&period, nullptr);
  std::this_thread::sleep_for(std::chrono::milliseconds(7));
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_plain = nh.advertise<std_msgs::Empty>("/plain", 1);
  g_number = nh.advertise<std_msgs::Empty>("/number", 1);
  g_brace = nh.advertise<std_msgs::Empty>("/brace", 1);
  g_both = nh.advertise<std_msgs::Empty>("/both", 1);
  g_rate = nh.advertise<std_msgs::Empty>("/rate", 1);
  g_helped = nh.advertise<std_msgs::Empty>("/helped", 1);
  g_once = nh.advertise<std_msgs::Empty>("/once", 1);
  g_sometimes = nh.advertise<std_msgs::Empty>("/sometimes", 1);
  g_deep = nh.advertise<std_msgs::Empty>("/deep", 1);
  Node node(nh);
  std::thread member_thread(&Node::run, &node);
  std::thread threads[] = {std::thread(brace), std::thread(both), std::thread(rate), std::thread(helped)};
  ros::Timer plain = nh.createTimer(ros::Duration(0.25), onPlain);
  double seconds = 0.5;
  ros::Timer number = nh.createTimer(ros::Duration(seconds), onNumber);
  ros::Timer once = nh.createTimer(ros::Duration(3.0), onOnce, true, false);
  bool once_only = false;
  ros::Timer running = nh.createTimer(ros::Duration(0.25), onPlain, once_only, true);
  ros::spin();
}
