// A condition on constants chooses once and for all: what it leads past is never done.
//
// expect: Count = count : { constant_condition(E, "1"), operator(E, _) }, Count = 10
// expect: Count = count : { constant_condition(E, "0"), operator(E, _) }, Count = 10
// expect: Count = count : { dead_expr(E), call(E, "publish") }, Count = 9
// expect: reactive /in -> /out must
#include <ros/ros.h>
#include <std_msgs/Int32.h>

const int kTwo = 2;
ros::Publisher g_pub;
ros::Publisher g_never_pub;  // expect: port([_, "publisher", "never"])

void send(int number)
{
  std_msgs::Int32 message;
  message.data = number;
  g_pub.publish(message);
}

void never(const std_msgs::Int32& message)
{
  if (false)
    g_never_pub.publish(message);
  if (!true)
    g_never_pub.publish(message);
  if (kTwo == 3)
    g_never_pub.publish(message);
  if (kTwo != 2)
    g_never_pub.publish(message);
  if (kTwo < 2)
    g_never_pub.publish(message);
  if (kTwo <= 1)
    g_never_pub.publish(message);
  if (kTwo > 2)
    g_never_pub.publish(message);
  if (kTwo >= 3)
    g_never_pub.publish(message);
  if (kTwo)
    return;
  g_never_pub.publish(message);
}

void always(const std_msgs::Int32& message)
{
  if (true)
    send(1);
  if (!false)
    send(2);
  if (kTwo == 2)
    send(3);
  if (kTwo != 3)
    send(4);
  if (kTwo < 3)
    send(5);
  if (kTwo <= 2)
    send(6);
  if (kTwo > 1)
    send(7);
  if (kTwo >= 2)
    send(8);
}

void partly(const std_msgs::Int32& message)
{
  if (message.data > 5 && false)
    send(1);
  if (message.data > 6 || true)
    send(2);
  if (kTwo == 2 && true)
    send(3);
  if (kTwo == 3 || false)
    send(4);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_pub = nh.advertise<std_msgs::Int32>("/out", 1);
  g_never_pub = nh.advertise<std_msgs::Int32>("never", 1);
  ros::Subscriber never_sub = nh.subscribe("/never_in", 1, never);  // expect-not: reactive /never_in -> never
  ros::Subscriber always_sub = nh.subscribe("/in", 1, always);
  ros::Subscriber partly_sub = nh.subscribe("/partly", 1, partly);
  ros::spin();
}
