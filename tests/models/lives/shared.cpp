#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Empty.h>

// what a parameter decides for a timer decides nothing for the callback that sends by the same function
class Node {
public:
  Node() {
    ros::NodeHandle("~").param("limit", limit_, 3);
    halt_ = nh_.advertise<std_msgs::Empty>("halt", 1);
    stop_ = nh_.subscribe("stop", 1, &Node::onStop, this);
    timer_ = nh_.createTimer(ros::Duration(0.1), &Node::onTimer, this);
  }

private:
  void halt() { halt_.publish(std_msgs::Empty()); }

  void onStop(const std_msgs::Bool& msg) {
    if (msg.data) halt();
  }

  void onTimer(const ros::TimerEvent&) {
    if (++missed_ > limit_) halt();
  }

  ros::NodeHandle nh_;
  ros::Publisher halt_;
  ros::Subscriber stop_;
  ros::Timer timer_;
  int limit_, missed_ = 0;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
