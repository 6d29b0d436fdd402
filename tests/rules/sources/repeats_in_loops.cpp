// What is changed several times in one reaction: in a loop, and in a function that is called in one; not in the loop that times the rounds.
//
// expect: 2 = count : { repeated(_) }
// expect: repeated(E), location(E, _, 16, _)
// expect: repeated(E), location(E, _, 22, _)
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <std_msgs/Int32.h>

int g_all = 0, g_calls = 0, g_messages = 0, g_rounds = 0;
ros::Publisher g_pub;

void count();

void onIn(const std_msgs::Int32& msg) {
  for (int i = 0; i < msg.data; ++i) ++g_all;
  for (int i = 0; i < msg.data; ++i) count();
  ++g_messages;
  if (g_all > 10 && g_calls > 10 && g_messages > 10) g_pub.publish(std_msgs::Empty());
}

void count() { ++g_calls; }

int main(int argc, char** argv) {
  ros::init(argc, argv, "counter");
  ros::NodeHandle nh;
  g_pub = nh.advertise<std_msgs::Empty>("out", 1);
  ros::Subscriber sub = nh.subscribe("in", 1, onIn);
  ros::Rate rate(5);
  while (ros::ok()) {
    if (++g_rounds % 5 == 0) g_pub.publish(std_msgs::Empty());
    ros::spinOnce();
    rate.sleep();
  }
}
