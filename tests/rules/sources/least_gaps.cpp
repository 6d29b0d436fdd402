// What is sent a while after the last time: as a duration, in seconds, in another order; not under a further condition, nor where another callback sets the moment back.
//
// expect: least_gap(In, Out, "0.25", "1"), In = [_, _, "in"], Out = [_, _, "slow"]
// expect: least_gap(In, Out, "0.5", "1"), In = [_, _, "in"], Out = [_, _, "slower"]
// expect: 2 = count : { least_gap(_, _, _, _) }
#include <ros/ros.h>
#include <std_msgs/Empty.h>

class Node {
public:
  Node() : period_(0.25) {
    slow_pub_ = nh_.advertise<std_msgs::Empty>("slow", 1);
    slower_pub_ = nh_.advertise<std_msgs::Empty>("slower", 1);
    some_pub_ = nh_.advertise<std_msgs::Empty>("some", 1);
    again_pub_ = nh_.advertise<std_msgs::Empty>("again", 1);
    in_ = nh_.subscribe("in", 1, &Node::onIn, this);
    reset_ = nh_.subscribe("reset", 1, &Node::onReset, this);
  }

private:
  void onIn(const std_msgs::Empty& msg) {
    const ros::Time now = ros::Time::now();
    if (now - slow_ >= period_) {
      slow_ = now;
      slow_pub_.publish(msg);
    }
    if (0.5 < (now - slower_).toSec()) {
      slower_ = ros::Time::now();
      slower_pub_.publish(msg);
    }
    if ((now - some_).toSec() > 0.5) {
      some_ = now;
      if (ready_) some_pub_.publish(msg);
    }
    if ((now - again_).toSec() > 0.5) {
      again_ = now;
      again_pub_.publish(msg);
    }
  }
  void onReset(const std_msgs::Empty&) {
    ready_ = true;
    again_ = ros::Time::now();
  }

  ros::NodeHandle nh_;
  ros::Publisher slow_pub_, slower_pub_, some_pub_, again_pub_;
  ros::Subscriber in_, reset_;
  ros::Duration period_;
  ros::Time slow_, slower_, some_, again_;
  bool ready_ = false;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
