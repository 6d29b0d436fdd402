// A call that never returns ends its block: what follows it there is never done, what follows elsewhere hangs on the way past it.
//
// expect: reactive /in -> /out may if "!(message.data < 0)"
// expect: reactive /certain -> /out must
// expect: reactive /fatal -> /out may if "!(message.data < 0)"
// expect: Count = count : { dead_expr(E), call(E, "publish") }, Count = 2
// expect: reactive /fatal -> /obituary may if "message.data < 0"
// expect-only: reactive
// expect-only: publisher
#include <cstdlib>
#include <ros/ros.h>
#include <std_msgs/Int32.h>

ros::Publisher g_pub;

void onIn(const std_msgs::Int32& message)
{
  if (message.data < 0)
    exit(1);
  g_pub.publish(message);
}

void onCertain(const std_msgs::Int32& message)
{
  g_pub.publish(message);
}

void onEnd(const std_msgs::Int32& message)
{
  if (message.data < 0)
    std::abort();
  else
    exit(0);
  g_pub.publish(message);  // expect-not: reactive /end -> /out
}

void onFatal(const std_msgs::Int32& message)
{
  if (message.data < 0)
  {
    ros::NodeHandle().advertise<std_msgs::Int32>("/obituary", 1).publish(message);  // expect: publisher /obituary
    std::terminate();
    ros::NodeHandle().advertise<std_msgs::Int32>("/afterlife", 1).publish(message);
  }
  g_pub.publish(message);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_pub = nh.advertise<std_msgs::Int32>("/out", 1);  // expect: publisher /out
  ros::Subscriber in_sub = nh.subscribe("/in", 1, onIn);
  ros::Subscriber certain_sub = nh.subscribe("/certain", 1, onCertain);
  ros::Subscriber end_sub = nh.subscribe("/end", 1, onEnd);
  ros::Subscriber fatal_sub = nh.subscribe("/fatal", 1, onFatal);
  ros::spin();
}
