// Waits for a first `ping` in a loop. That it waits for `hello`, too, is no circle.
// expect-not: finding circular-wait "*hello*"
// expect-not: queue_concurrent(_)
#include <ros/ros.h>
#include <std_msgs/Empty.h>

bool has_ping = false;
bool has_hello = false;

void onPing(const std_msgs::Empty&) { has_ping = true; }
void onHello(const std_msgs::Empty&) { has_hello = true; }

int main(int argc, char** argv) {
  ros::init(argc, argv, "pong");
  ros::NodeHandle nh;
  ros::Publisher pub = nh.advertise<std_msgs::Empty>("pong", 1);
  ros::Subscriber ping_sub = nh.subscribe("ping", 1, onPing);  // expect: finding circular-wait "/pong waits for /ping, which /ping provides only after it has received /pong,*"
  ros::Subscriber hello_sub = nh.subscribe("hello", 1, onHello);
  ros::Rate rate(10);
  while (ros::ok() && (!has_ping || !has_hello)) {
    ros::spinOnce();
    rate.sleep();
  }
  for (; ros::ok(); rate.sleep()) {
    ros::spinOnce();
    pub.publish(std_msgs::Empty());
  }
}
