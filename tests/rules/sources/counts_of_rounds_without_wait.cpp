// A loop that waits by a rate, but not in each round: what is sent in such a round is sent any number of times until the next wait.
//
// expect: round_sends(_, [_, _, "before"], "1")
// expect: round_sends(_, [_, _, "before"], "many")
// expect: round_sends(_, [_, _, "behind"], "1")
// expect-not: round_sends(_, [_, _, "behind"], "many")
// expect: round_sends(_, [_, _, "each"], "1")
// expect-not: round_sends(_, [_, _, "each"], "many")
#include <ros/ros.h>
#include <std_msgs/Int32.h>

bool ready = false;

void onReady(const std_msgs::Int32& message) { ready = message.data > 0; }

void skips(ros::NodeHandle& nh)
{
  ros::Publisher before = nh.advertise<std_msgs::Int32>("before", 1);
  ros::Publisher behind = nh.advertise<std_msgs::Int32>("behind", 1);
  ros::Rate rate(5);
  while (ros::ok())
  {
    ros::spinOnce();
    std_msgs::Int32 message;
    before.publish(message);
    if (!ready)
      continue;
    behind.publish(message);
    rate.sleep();
  }
}

void waits(ros::NodeHandle& nh)
{
  ros::Publisher each = nh.advertise<std_msgs::Int32>("each", 1);
  ros::Rate rate(5);
  while (ros::ok())
  {
    ros::spinOnce();
    std_msgs::Int32 message;
    each.publish(message);
    if (!ready)
    {
      rate.sleep();
      continue;
    }
    rate.sleep();
  }
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  ros::Subscriber subscriber = nh.subscribe("ready", 1, onReady);
  if (argc > 1)
    skips(nh);
  else
    waits(nh);
}
