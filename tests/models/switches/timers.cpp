// expect: 24 off: 35 on, 36 off
// expect: 25 off: 37 on if armed_, 38 off
// expect: 26 off: 39 off
// expect: 45 off: 45 on
// expect: 64 off: 64 on perhaps, 64 off perhaps
// a timer that runs all the time, one that something else gets, one that a copy may start, and one of a class with two objects are none
#include <ros/ros.h>
#include <std_msgs/Empty.h>

void keep(ros::Timer& timer);

struct Part {
  ros::NodeHandle nh;
  ros::Timer timer;
  void tick(const ros::TimerEvent&) {}
  void start() { timer = nh.createTimer(ros::Duration(1), &Part::tick, this, false, false); }
  void go() { timer.start(); }
};

class Node {
public:
  Node() {
    out_ = nh_.advertise<std_msgs::Empty>("out", 1);
    stopped_ = nh_.createTimer(ros::Duration(0.1), &Node::tick, this, false, false);
    armedly_ = nh_.createTimer(ros::Duration(0.2), &Node::tick, this, false, false);
    brief_ = nh_.createTimer(ros::Duration(0.3), &Node::tick, this); brief_.stop();
    steady_ = nh_.createTimer(ros::Duration(0.4), &Node::tick, this);
    handed_ = nh_.createTimer(ros::Duration(0.5), &Node::tick, this, false, false); keep(handed_);
    copied_ = nh_.createTimer(ros::Duration(0.6), &Node::tick, this, false, false);
    a_.start(); b_.start();
    in_ = nh_.subscribe("in", 1, &Node::onIn, this);
    go_ = nh_.subscribe("go", 1, &Node::onGo, this);
  }
  void onIn(const std_msgs::Empty&) {
    stopped_.start();
    stopped_.stop();
    if (armed_) armedly_.start();
    armedly_.stop();
    brief_.stop();
    armed_ = !armed_;
    a_.go();
  }
  void onGo(const std_msgs::Empty&) {
    ros::Timer other = copied_;
    late_ = nh_.createTimer(ros::Duration(0.7), &Node::tick, this);
    other.start();
    run();
  }
  void tick(const ros::TimerEvent&) { out_.publish(std_msgs::Empty()); }

private:
  void run();

  ros::NodeHandle nh_;
  ros::Publisher out_;
  ros::Subscriber in_, go_;
  ros::Timer stopped_, armedly_, brief_, steady_, handed_, copied_, late_;
  Part a_, b_;
  bool armed_ = false;
};

void Node::run() {
  ros::Rate rate(5);
  for (int i = 0; i < 9 && ros::ok(); ++i) { out_.publish(std_msgs::Empty()); rate.sleep(); }
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
