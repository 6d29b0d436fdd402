// One helper serves two callbacks: what it makes of one message does not come out at the other.
//
// expect: port_flow([_, _, "/left"], [_, _, "/left_out"], "data", "reactive")
// expect: port_flow([_, _, "/right"], [_, _, "/right_out"], "data", "reactive")
// expect: Count = count : { port_flow(_, _, _, _) }, Count = 2
// expect: flow_always([_, _, "/left"], [_, _, "/left_out"], "reactive")
#include <ros/ros.h>
#include <std_msgs/Int32.h>

ros::Publisher left_pub, right_pub;

void scale(const std_msgs::Int32& in, std_msgs::Int32& out) { out.data = 2 * in.data; }

void onLeft(const std_msgs::Int32& msg)
{
  std_msgs::Int32 result;
  scale(msg, result);
  left_pub.publish(result);
}

void onRight(const std_msgs::Int32& msg)
{
  std_msgs::Int32 result;
  scale(msg, result);
  right_pub.publish(result);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "scaler");
  ros::NodeHandle nh;
  ros::Subscriber left = nh.subscribe("/left", 1, onLeft), right = nh.subscribe("/right", 1, onRight);
  left_pub = nh.advertise<std_msgs::Int32>("/left_out", 1);
  right_pub = nh.advertise<std_msgs::Int32>("/right_out", 1);
  ros::spin();
}
