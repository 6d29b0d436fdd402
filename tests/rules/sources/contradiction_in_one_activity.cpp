// A condition on the node's own variable that cannot change between: what would need it to hold and not to hold is never done.
//
// expect: reactive /in -> /simulated if "g_simulated"
// expect: reactive /in -> /real if "!g_simulated"
// expect: reactive /in -> /both must
// expect-not: reactive /in -> /never
// expect: Count = count : { contradicted(A, E), sends(E, _) }, Count = 1
// expect: configuration g_simulated
#include <ros/ros.h>
#include <std_msgs/Empty.h>

ros::Publisher g_simulated_pub, g_real_pub, g_never_pub, g_both_pub;
bool g_simulated = false;

void sendReal()
{
  if (g_simulated)
    g_never_pub.publish(std_msgs::Empty());
  else
    g_real_pub.publish(std_msgs::Empty());
}

void onMessage(const std_msgs::Empty&)
{
  if (g_simulated)
    g_simulated_pub.publish(std_msgs::Empty());
  else
    sendReal();
  g_both_pub.publish(std_msgs::Empty());
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh, private_nh("~");
  private_nh.getParam("simulated", g_simulated);
  g_simulated_pub = nh.advertise<std_msgs::Empty>("/simulated", 1);
  g_real_pub = nh.advertise<std_msgs::Empty>("/real", 1);
  g_never_pub = nh.advertise<std_msgs::Empty>("/never", 1);
  g_both_pub = nh.advertise<std_msgs::Empty>("/both", 1);
  ros::Subscriber sub = nh.subscribe("/in", 1, onMessage);
  ros::spin();
}
