// A component that waits for subscribers before it sends has not sent too early; a loop that waits lets what it sends be read.
//
// expect: N = count : { sent_at_start(_, _) }, N = 0
// expect: N = count : { sent_in_a_row(_, _) }, N = 0
// expect: 2 = count : { decides(_, _) }, 10 = count : { port_value(_, _) }
#include <ros/ros.h>
#include <std_msgs/Int32.h>

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  ros::Publisher pub = nh.advertise<std_msgs::Int32>("/hello", 1);
  ros::Publisher slow = nh.advertise<std_msgs::Int32>("/slow", 1, true);
  ros::Publisher spun = nh.advertise<std_msgs::Int32>("/spun", 1, true);
  ros::Publisher endless = nh.advertise<std_msgs::Int32>("/endless", 1, true);
  std_msgs::Int32 message;
  if (pub.getNumSubscribers() > 0)
    pub.publish(message);
  for (int i = 0; i < 3; ++i)
  {
    slow.publish(message);
    ros::Duration(1).sleep();
  }
  for (int i = 0; i < 3; ++i)
  {
    spun.publish(message);
    ros::spinOnce();
  }
  while (ros::ok())
    endless.publish(message);
}
