// What a callback does is in the order of its calls, not in that of the lines: a function above, one that is called twice; not where calls exclude each other.
// expect: ordered_by_calls(F), function_name(F, "Node::onTwice")
// expect: ordered_by_calls(F), function_name(F, "Node::onStop")
// expect: 2 = count : { ordered_by_calls(_) }
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Empty.h>
#include <std_msgs/Int32.h>

class Node {
public:
  Node() : stopped_(false) {
    stop_ = nh_.subscribe("stop", 1, &Node::onStop, this);
    twice_ = nh_.subscribe("twice", 1, &Node::onTwice, this);
    level_ = nh_.subscribe("level", 1, &Node::onLevel, this);
    halt_ = nh_.advertise<std_msgs::Empty>("halt", 1);
    tell_ = nh_.advertise<std_msgs::Empty>("told", 1);
  }

private:
  void halt() { halt_.publish(std_msgs::Empty()); }
  void tell() { tell_.publish(std_msgs::Empty()); }

  void onStop(const std_msgs::Bool& pressed) {
    stopped_ = pressed.data;
    if (stopped_) halt();
  }

  void onTwice(const std_msgs::Empty&) {
    if (!stopped_) tell();
    if (stopped_) tell();
  }

  void onLevel(const std_msgs::Int32& level) {
    if (level.data > 2) {
      tell();
    } else if (level.data > 1) {
      stopped_ = false;
    } else {
      tell();
    }
  }

  ros::NodeHandle nh_;
  ros::Publisher halt_, tell_;
  ros::Subscriber stop_, twice_, level_;
  bool stopped_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
