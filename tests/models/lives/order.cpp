// expect: out_of_line 16 12
// expect: several_orders 13 22
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Empty.h>

class Node {
public:
  Node() : stopped_(false) { start(); }

private:
  void halt() { halt_.publish(std_msgs::Empty()); }
  void tell() { tell_.publish(std_msgs::Empty()); }

  void onStop(const std_msgs::Bool& pressed) {
    stopped_ = pressed.data;
    if (stopped_) halt();
  }

  void onGo(const std_msgs::Empty&) {
    if (!stopped_) tell();
    stopped_ = true;
    if (stopped_) tell();
  }

  void start() {
    halt_ = nh_.advertise<std_msgs::Empty>("halt", 1);
    tell_ = nh_.advertise<std_msgs::Empty>("told", 1);
    stop_ = nh_.subscribe("stop", 1, &Node::onStop, this);
    go_ = nh_.subscribe("go", 1, &Node::onGo, this);
  }

  ros::NodeHandle nh_;
  ros::Publisher halt_, tell_;
  ros::Subscriber stop_, go_;
  bool stopped_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
