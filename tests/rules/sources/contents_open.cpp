// Messages into which more is put than what their fields are given by name.
// expect: content_sent(C, M), location(C, _, 19, _)
// expect-not: content_given(_, "data", D, _), location(D, _, 16, _)
// expect-not: content_given(_, "linear.x", D, _), location(D, _, 24, _)
// expect-not: content_sent(C, _), location(C, _, 36, _)
// expect: content_given(_, "data", D, _), location(D, _, 41, _)
#include <ros/ros.h>
#include <geometry_msgs/Twist.h>
#include <std_msgs/Int32.h>

ros::Publisher out, speed;

void onNumber(const std_msgs::Int32 & in) {
  if (in.data == 1) {
    std_msgs::Int32 message;
    message.data = 1;
    int & part = message.data;
    part = in.data;
    out.publish(message);
  }
  if (in.data == 2) {
    geometry_msgs::Twist message;
    // the speed
    message.linear.x = 1;
    auto & part = message.linear;
    part.x = in.data;
    speed.publish(message);
  }
  if (in.data == 3) {
    std_msgs::Int32 message;
    auto change = [&]() {
      message.data = in.data;
    };
    message.data = 1;
    change();
    out.publish(message);
  }
  if (in.data == 4) {
    std_msgs::Int32 message;
    //
    message.data = 1;
    int part = message.data;
    part = 3;
    out.publish(message);
  }
}

int main(int argc, char ** argv) {
  ros::init(argc, argv, "teller");
  ros::NodeHandle nh;
  out = nh.advertise<std_msgs::Int32>("out", 1);
  speed = nh.advertise<geometry_msgs::Twist>("speed", 1);
  ros::Subscriber sub = nh.subscribe("number", 1, onNumber);
  ros::spin();
}
