// A loop that waits for something at the start is not where the main activity begins.
//
// expect: Count = count : { activity(Root, "loop") }, Count = 1
// expect: periodic /out 5 Hz
// expect: state g_arrived = false
#include <ros/ros.h>
#include <std_msgs/Empty.h>

ros::Publisher g_pub;
bool g_arrived = false;

void onIn(const std_msgs::Empty&)
{
  g_arrived = true;
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_pub = nh.advertise<std_msgs::Empty>("/out", 1);
  ros::Subscriber sub = nh.subscribe("/in", 1, onIn);
  while (true)
  {
    if (argc > 1)
      break;
  }
  ros::Rate rate(5);
  while (ros::ok())
  {
    if (g_arrived)
      g_pub.publish(std_msgs::Empty());
    ros::spinOnce();
    rate.sleep();
  }
}
