// Publishers that functions fill in through pointers and arrays.
//
// expect: periodic one 10 Hz
// expect: periodic many 10 Hz
#include <ros/ros.h>
#include <std_msgs/Empty.h>

static void makeOne(ros::NodeHandle node, ros::Publisher *publisher)
{
  *publisher = node.advertise<std_msgs::Empty>("one", 1);
}

static void makeMany(ros::NodeHandle node, ros::Publisher publishers[], int count)
{
  for (int i = 0; i < count; i++)
    publishers[i] = node.advertise<std_msgs::Empty>("many", 1);
}

int main(int argc, char **argv)
{
  ros::init(argc, argv, "filled");
  ros::NodeHandle node;
  ros::Publisher one;
  ros::Publisher many[3];
  makeOne(node, &one);
  makeMany(node, many, 3);
  ros::Rate rate(10);
  while (ros::ok())
  {
    one.publish(std_msgs::Empty());
    for (int i = 0; i < 3; i++)
      many[i].publish(std_msgs::Empty());
    rate.sleep();
  }
}
