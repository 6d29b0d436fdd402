// What is only sent while the component starts, and what is sent in a row.
//
// expect: N = count : { sent_at_start(_, _) }, N = 5
// expect: N = count : { sent_in_a_row(_, _) }, N = 1
// expect: sent_at_start([_, "publisher", "/hello"], _)
// expect: sent_at_start([_, "publisher", "/told"], _)
// expect: sent_at_start([_, "publisher", "/table"], _)
// expect: sent_at_start([_, "publisher", "/first"], _)
// expect: sent_at_start([_, "publisher", "/unlatched"], _)
// expect: sent_in_a_row([_, "publisher", "/table"], _)
#include <ros/ros.h>
#include <std_msgs/Int32.h>

std_msgs::Int32 g_message;
ros::Publisher g_later;
ros::Publisher g_both;

void announce(ros::Publisher& pub)
{
  pub.publish(g_message);
}

void never(ros::Publisher& pub)
{
  pub.publish(g_message);
}

void onTimer(const ros::TimerEvent&)
{
  g_later.publish(g_message);
  g_both.publish(g_message);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  ros::Publisher hello = nh.advertise<std_msgs::Int32>("/hello", 1);
  ros::Publisher told = nh.advertise<std_msgs::Int32>("/told", 1);
  ros::Publisher table = nh.advertise<std_msgs::Int32>("/table", 1, true);
  ros::Publisher first = nh.advertise<std_msgs::Int32>("/first", 1, true);
  ros::Publisher unlatched = nh.advertise<std_msgs::Int32>("/unlatched", 1);
  g_later = nh.advertise<std_msgs::Int32>("/later", 1);
  g_both = nh.advertise<std_msgs::Int32>("/both", 1);
  ros::Timer timer = nh.createTimer(ros::Duration(1), onTimer);

  hello.publish(g_message);
  announce(told);
  g_both.publish(g_message);
  for (int i = 0; i < 3; ++i)
  {
    g_message.data = i;
    table.publish(g_message);
    unlatched.publish(g_message);
    if (i == 0)
      first.publish(g_message);
  }
  ros::spin();
}
