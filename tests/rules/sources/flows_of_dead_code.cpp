// What stands where control never comes has no part in what is sent.
//
// expect: port_flow([_, _, "/in"], [_, _, "/alive"], "data", "deferred")
// expect-not: port_flow([_, _, "/in"], [_, _, "/dead"], _, _)
#include <ros/ros.h>
#include <std_msgs/Int32.h>

const bool USED = false;
int g_kept = 0;
ros::Publisher g_alive, g_dead;

void onIn(const std_msgs::Int32& msg) { g_kept = msg.data; }

void tick(const ros::TimerEvent&)
{
  std_msgs::Int32 alive, dead;
  if (!USED)
    alive.data = g_kept;
  g_alive.publish(alive);
  if (USED)
    dead.data = g_kept;
  g_dead.publish(dead);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  g_alive = nh.advertise<std_msgs::Int32>("/alive", 1);
  g_dead = nh.advertise<std_msgs::Int32>("/dead", 1);
  ros::Subscriber in = nh.subscribe("/in", 1, onIn);
  ros::Timer timer = nh.createTimer(ros::Duration(0.1), tick);
  ros::spin();
}
