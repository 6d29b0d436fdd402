// Loops that end by themselves, or wait only sometimes, are nothing periodic; nor is what other libraries run.
//
// expect: periodic /do 40 Hz mechanism=rate
// expect: periodic /nested 50 Hz mechanism=rate
// expect: periodic /early 20 Hz mechanism=rate
// expect: periodic "" 50 Hz
// expect-only: periodic
// expect: state g_phase = 0
// expect: transition g_phase = 1 on thread
// expect: transition g_phase = 2 on main
// expect-only: transition
// expect: Count = count : { endless_loop(H) }, Count = 5
// expect: Count = count : { timed_loop(H, C) }, Count = 4
// expect: Count = count : { activity(Root, Kind) }, Count = 7
// expect: activity(F, "end"), function_name(F, "Lasting::~Lasting")
// expect: Count = count : { activity(Root, "thread") }, Count = 1
// expect: Count = count : { activity(Root, "loop") }, Count = 4
// expect-not: enters(_, F), function_name(F, "elsewhere")
// expect: Count = count : { _timed_block(B), activity_part(Root, B), activity(Root, "thread") }, Count = 0
// expect-not: runs_later(_, F)
// expect-not: timer_callback(_, F)
// expect: 4 = count : { concurrent(_, _) }, 8 = count : { constant_node(_) }, 9 = count : { depends_on(_, _) }
#include <algorithm>
#include <boost/asio.hpp>
#include <csignal>
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <thread>
#include <vector>

// in other libraries
void elsewhere(int);
void elsewhereToo();
void onElsewhere(const ros::TimerEvent&);
void onRead(const boost::system::error_code&, size_t);
bool connected();

ros::Publisher g_pub, g_do_pub, g_nested_pub, g_early_pub;
std::vector<int> g_numbers;
bool g_on = true, g_off = true, g_ended = false;
double g_level = 0;
int g_phase = 0, g_count = 0;

void send()
{
  g_pub.publish(std_msgs::Empty());
}

// it waits in rounds of its own, as often as it happens
void pauseSometimes()
{
  for (int i = 0; i < g_count; ++i)
    ros::Duration(0.1).sleep();
}

class Lasting
{
public:
  ~Lasting()
  {
    g_ended = true;
  }
};

class Passing
{
public:
  ~Passing()
  {
    g_count = 0;
  }
};

class Fleeting
{
public:
  ~Fleeting()
  {
    g_ended = true;
  }
};

void finite()
{
  ros::Rate rate(5);
  while (g_count < 5)
  {
    send();
    rate.sleep();
  }
  while (0)
  {
    send();
    rate.sleep();
  }
  for (int number : g_numbers)
  {
    send();
    rate.sleep();
  }
  bool local = true;
  while (local)
  {
    send();
    rate.sleep();
  }
  while (g_on && connected())
  {
    send();
    rate.sleep();
  }
  while (ros::ok() || connected())
  {
    send();
    rate.sleep();
  }
  while (g_level)
  {
    send();
    rate.sleep();
  }
  while (!g_level)
  {
    send();
    rate.sleep();
  }
  while (-g_count)
  {
    send();
    rate.sleep();
  }
}

void work()
{
  finite();
  ros::Rate rate(40);
  do
  {
    g_do_pub.publish(std_msgs::Empty());
    rate.sleep();
  } while (ros::ok());
  while (ros::ok())
  {
    send();
    pauseSometimes();
    g_phase = 1;
  }
  ros::Rate nested(50);
  while ((ros::ok() && connected()) && g_on)
  {
    g_nested_pub.publish(std_msgs::Empty());
    nested.sleep();
  }
  while (!g_ended)
    nested.sleep();
}

// nobody calls it
void idle(ros::Rate& rate)
{
  while (g_off)
    rate.sleep();
}

// nobody calls it
void unused(ros::NodeHandle& nh, boost::asio::serial_port& port)
{
  std::thread thread(send);
  signal(SIGINT, elsewhere);
  ros::Timer timer = nh.createTimer(ros::Duration(1.0), onElsewhere);
  port.async_read_some(boost::asio::buffer(""), onRead);
  Fleeting fleeting;
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_pub = nh.advertise<std_msgs::Empty>("/out", 1);
  g_do_pub = nh.advertise<std_msgs::Empty>("/do", 1);
  g_nested_pub = nh.advertise<std_msgs::Empty>("/nested", 1);
  g_early_pub = nh.advertise<std_msgs::Empty>("/early", 1);
  Lasting lasting;
  Passing passing;
  std::thread thread(work);
  std::thread other(elsewhereToo);
  signal(SIGINT, elsewhere);
  std::for_each(g_numbers.begin(), g_numbers.end(), elsewhere);
  ros::Timer timer = nh.createTimer(ros::Duration(1.0), onElsewhere);
  boost::asio::io_service service;
  boost::asio::serial_port port(service);
  char buffer[8];
  port.async_read_some(boost::asio::buffer(buffer), onRead);
  ros::Rate rate(20);
  g_phase = 0;
  while (ros::ok() && g_off)
  {
    if (g_phase == 1)
      g_early_pub.publish(std_msgs::Empty());
    service.poll();
    ros::spinOnce();
    rate.sleep();
  }
  g_phase = 2;
}
