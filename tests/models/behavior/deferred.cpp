// Reactions through stored state: what arrives is kept, and a timer sends something made from it.
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Int32.h>

int last = 0, unused = 0;
ros::Publisher pub, beat;

void onValue(const std_msgs::Int32& m) { last = m.data; }
void onOther(const std_msgs::Int32& m) { unused = m.data; }
void onTimer(const ros::TimerEvent&)
{
  std_msgs::Int32 message;
  message.data = last + 1;
  pub.publish(message);
  beat.publish(std_msgs::Bool());
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "n");
  ros::NodeHandle nh;
  pub = nh.advertise<std_msgs::Int32>("out", 1);
  beat = nh.advertise<std_msgs::Bool>("beat", 1);
  ros::Subscriber s1 = nh.subscribe("value", 1, onValue);
  ros::Subscriber s2 = nh.subscribe("other", 1, onOther);
  ros::Timer timer = nh.createTimer(ros::Duration(0.1), onTimer);
  ros::spin();
}
// expect: periodic timer 10.0 None out,beat []
// expect: deferred value -> out by ::last
