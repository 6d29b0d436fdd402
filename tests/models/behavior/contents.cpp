// A node that always says something is in modes, too: one decides what it says, and what it becomes. What decides about itself alone, or
// about contents alone, does not.
// expect: state Node::state_ = FORWARD
// expect: periodic timer 20.0 None cmd []
// expect: state Node::ticks_ = 0
// expect: transition Node::ticks_ . None on periodic [] := ++ticks_
// expect: transition Node::state_ . None on periodic [state_ == BACK && ticks_ % 2 == 0] := FORWARD
// expect: transition Node::state_ . None on periodic [state_ == FORWARD && blocked()] := BACK
#include <geometry_msgs/Twist.h>
#include <ros/ros.h>
#include <std_msgs/Bool.h>

enum State { FORWARD, BACK };

class Node {
public:
  Node() : state_(FORWARD), gain_(1.0), warned_(false) {
    pub_ = nh_.advertise<geometry_msgs::Twist>("cmd", 1);
    sub_ = nh_.subscribe("fast", 1, &Node::onFast, this);
    timer_ = nh_.createTimer(ros::Duration(0.05), &Node::onTimer, this);
  }

private:
  bool blocked();
  void onFast(const std_msgs::Bool& fast) { fast_ = fast.data; }
  void go(State state) { state_ = state; }
  void onTimer(const ros::TimerEvent&) {
    geometry_msgs::Twist cmd;
    ++ticks_;
    if (!warned_) {
      ROS_WARN("begins");
      warned_ = true;
    }
    switch (state_) {
      case FORWARD:
        cmd.linear.x = gain_;
        if (blocked()) go(BACK);
        break;
      case BACK:
        cmd.linear.x = -gain_;
        if (ticks_ % 2 == 0) go(FORWARD);
        break;
    }
    if (fast_) cmd.linear.y = 1.0;
    pub_.publish(cmd);
  }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber sub_;
  ros::Timer timer_;
  State state_;
  double gain_;
  bool warned_, fast_ = false;
  int ticks_ = 0;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
