// Variables of the component that are static, of a class or of a function, and assignments to parts and through calls.
//
// expect: state count_ = 0
// expect: component_variable(V), variable_name(V, "count_")
// expect: state seen = false
// expect: transition seen = true
// expect: component_variable(V), variable_name(V, "seen")
// expect: assignment(E, V, "argument"), variable_name(V, "g_filled")
// expect: Count = count : { assignment(E, V, How), variable_name(V, "g_list") }, Count = 1
// expect: state g_filled
#include <ros/ros.h>
#include <std_msgs/Int32.h>

ros::Publisher g_pub;
int g_list[3] = {0, 0, 0};
int g_filled = 0;

class Node
{
public:
  static void onCount(const std_msgs::Int32& message)
  {
    count_ = message.data;
  }
  static int count_;
  ros::Publisher pub_;
};
int Node::count_ = 0;

void fill(int& number)
{
  number = 3;
}

void onIn(const std_msgs::Int32& message)
{
  static bool seen = false;
  if (!seen)
    g_pub.publish(message);
  seen = true;
  g_list[1] = message.data;
  fill(g_filled);
  if (Node::count_ > 3 && g_list[1] > 2 && g_filled > 1)
    g_pub.publish(message);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_pub = nh.advertise<std_msgs::Int32>("/out", 1);
  ros::Subscriber sub = nh.subscribe("/in", 1, onIn);
  ros::Subscriber count_sub = nh.subscribe("/count", 1, Node::onCount);
  ros::spin();
}
