// Callbacks that end the node, or throw what nothing handles; `checked` handles it.
// expect: unsteady 26 a callback may end the node
// expect: unsteady 26 a callback may end with an exception
// expect: unheard stop a callback may end the node
// expect: unheard stop a callback may end with an exception
// expect: unheard in a callback may end the node
// expect: unheard in a callback may end with an exception
// expect: unheard checked a callback may end the node
// expect: unheard checked a callback may end with an exception
#include <ros/ros.h>
#include <stdexcept>
#include <std_msgs/Int32.h>

class Node {
public:
  Node() {
    pub_ = nh_.advertise<std_msgs::Int32>("out", 1);
    stop_ = nh_.subscribe("stop", 1, &Node::onStop, this);
    in_ = nh_.subscribe("in", 1, &Node::onIn, this);
    checked_ = nh_.subscribe("checked", 1, &Node::onChecked, this);
    begin();
  }

private:
  void begin() {
    timer_ = nh_.createTimer(ros::Duration(0.1), &Node::tick, this);
  }
  void check(int value) {
    if (value < 0) throw std::invalid_argument("negative");
  }
  void onStop(const std_msgs::Int32&) { ros::shutdown(); }
  void onIn(const std_msgs::Int32& msg) {
    check(msg.data);
    pub_.publish(msg);
  }
  void onChecked(const std_msgs::Int32& msg) {
    try {
      check(msg.data);
    } catch (const std::exception&) {
      return;
    }
  }
  void tick(const ros::TimerEvent&) { pub_.publish(std_msgs::Int32()); }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber stop_, in_, checked_;
  ros::Timer timer_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
