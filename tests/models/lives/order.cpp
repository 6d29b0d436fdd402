// expect: out_of_line 17 13
// expect: several_orders 14 23
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Empty.h>
#include <std_msgs/Int32.h>

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

  // of these, each excludes the others: there is no order
  void onLevel(const std_msgs::Int32& level) {
    if (level.data > 2) {
      tell();
    } else if (level.data > 1) {
      stopped_ = false;
    } else {
      tell();
    }
  }

  void start() {
    level_ = nh_.subscribe("level", 1, &Node::onLevel, this);
    halt_ = nh_.advertise<std_msgs::Empty>("halt", 1);
    tell_ = nh_.advertise<std_msgs::Empty>("told", 1);
    stop_ = nh_.subscribe("stop", 1, &Node::onStop, this);
    go_ = nh_.subscribe("go", 1, &Node::onGo, this);
  }

  ros::NodeHandle nh_;
  ros::Publisher halt_, tell_;
  ros::Subscriber stop_, go_, level_;
  bool stopped_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
