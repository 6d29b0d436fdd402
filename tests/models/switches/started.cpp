// starts: out 19 certainly, out 26 perhaps, tried 17 perhaps
#include <ros/ros.h>
#include <std_msgs/Empty.h>

class Node {
public:
  Node() {
    out_ = nh_.advertise<std_msgs::Empty>("out", 1);
    tried_ = nh_.advertise<std_msgs::Empty>("tried", 1);
    in_ = nh_.subscribe("in", 1, &Node::onIn, this);
    begin();
    if (nh_.ok()) tell();
  }
  void later() { out_.publish(std_msgs::Empty()); }

private:
  void begin() { if (nh_.ok()) tried_.publish(std_msgs::Empty());

    out_.publish(std_msgs::Empty());
  }
  void onIn(const std_msgs::Empty&) {
    tell();
    later();
  }
  void tell() {
    out_.publish(std_msgs::Empty());
  }

  ros::NodeHandle nh_;
  ros::Publisher out_, tried_;
  ros::Subscriber in_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::Rate rate(1);
  while (ros::ok()) {
    node.later();
    ros::spinOnce();
    rate.sleep();
  }
}
