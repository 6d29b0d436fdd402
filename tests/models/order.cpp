#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Empty.h>

// what its callbacks do is in the order of their calls, which is not that of the lines
class Node {
public:
  Node() {
    told_ = nh_.advertise<std_msgs::Empty>("told", 1);
    done_ = nh_.advertise<std_msgs::Empty>("done", 1);
    twice_ = nh_.subscribe("twice", 1, &Node::onTwice, this);
    above_ = nh_.subscribe("above", 1, &Node::onAbove, this);
    either_ = nh_.subscribe("either", 1, &Node::onEither, this);
    again_ = nh_.subscribe("again", 1, &Node::onAgain, this);
  }

private:
  enum Mode { OFF, SLOW, FAST };

  void tell() {
    if (mode_ == FAST) done_.publish(std_msgs::Empty());
  }

  void set(Mode mode) {
    if (mode == mode_) return;
    mode_ = mode;
    told_.publish(std_msgs::Empty());
    tell();
  }

  void onTwice(const std_msgs::Empty&) {
    set(SLOW);
    set(FAST);
  }

  void onAbove(const std_msgs::Empty&) {
    mode_ = FAST;
    tell();
  }

  void onEither(const std_msgs::Bool& msg) {
    if (msg.data) {
      set(FAST);
      set(SLOW);
    } else {
      set(SLOW);
      tell();
    }
  }

  void onAgain(const std_msgs::Empty&) {
    if (mode_ != OFF) set(OFF);
    tell();
    set(FAST);
  }

  ros::NodeHandle nh_;
  ros::Publisher told_, done_;
  ros::Subscriber twice_, above_, either_, again_;
  Mode mode_ = OFF;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
