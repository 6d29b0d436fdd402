// Under which conditions something is sent: of every decision on the way its sense, and of ended loops none.
//
// expect: N = count : { guard_step(_, _, _, "exception", _) }, N = 1
// expect: N = count : { guard_step(_, _, _, "ended", _) }, N = 2
// expect: N = count : { guard_step(_, _, _, "case", _) }, N = 1
// expect: N = count : { guard_step(_, _, _, "default", _) }, N = 1
// expect: N = count : { guard_step(_, _, _, "true", _) }, N = 2
// expect: N = count : { guard_step(_, _, _, "false", _) }, N = 1
// expect: N = count : { guard_step(_, _, _, "always", _) }, N = 16
// expect: reactive /mode -> /one may if "message.data == 1"
// expect: reactive /mode -> /other
// expect: reactive /mode -> /after must
// expect: reactive /mode -> /caught may
// expect: reactive /mode -> /late may
// expect: reactive /mode -> /ready may if "!(!ready) && message.data > 3"
// expect-not: captured(_, _, _); _not_with(_, _, _, _); _comparison(_, _, _, _); _local_made_of_parameter(_, _); _asks_for_arrival(_, _, _); _lasts(_)
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <stdexcept>

ros::NodeHandle* g_nh;
ros::Publisher g_one, g_other, g_after, g_caught, g_ready, g_late;
ros::Subscriber g_sub;

int parse(int number)
{
  if (number < 0)
    throw std::runtime_error("negative");
  return number;
}

void sendReady(const std_msgs::Int32& message, bool ready)
{
  if (!ready)
    return;
  if (message.data > 3)
    g_ready.publish(message);
}

void search(const std_msgs::Int32& message);

void onMode(const std_msgs::Int32& message)
{
  switch (message.data)
  {
    case 1:
      g_one.publish(message);
      break;
    default:
      g_other.publish(message);
  }
  for (int i = 0; i < 3; ++i)
    ROS_INFO("%d", i);
  g_after.publish(message);
  try
  {
    parse(message.data);
  }
  catch (const std::runtime_error& error)
  {
    g_caught.publish(message);
  }
  sendReady(message, message.data > 1);
  search(message);
}

void search(const std_msgs::Int32& message)
{
  for (int i = 0; i < 3; ++i)
  {
    if (i == message.data)
      return;
  }
  g_late.publish(message);
}

void connect()
{
  g_sub = g_nh->subscribe("/mode", 1, onMode);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_nh = &nh;
  g_one = nh.advertise<std_msgs::Int32>("/one", 1);
  g_other = nh.advertise<std_msgs::Int32>("/other", 1);
  g_after = nh.advertise<std_msgs::Int32>("/after", 1);
  g_caught = nh.advertise<std_msgs::Int32>("/caught", 1);
  g_ready = nh.advertise<std_msgs::Int32>("/ready", 1);
  g_late = nh.advertise<std_msgs::Int32>("/late", 1);
  if (argc > 1)
    connect();
  ros::spin();
}
