// What decides whether something is sent is the message alone, or something else as well; what is sent are constants, or what was computed.
// expect: asks_message in named
// expect: sends_constants named
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Int32.h>

class Node {
public:
  Node() {
    named_ = nh_.advertise<std_msgs::Bool>("named", 1);
    kept_ = nh_.advertise<std_msgs::Int32>("kept", 1);
    always_ = nh_.advertise<std_msgs::Int32>("always", 1);
    sub_ = nh_.subscribe("in", 1, &Node::onIn, this);
    limit_sub_ = nh_.subscribe("limit", 1, &Node::onLimit, this);
  }

private:
  void onLimit(const std_msgs::Int32& limit) { limit_ = limit.data; }

  void onIn(const std_msgs::Int32& in) {
    std_msgs::Bool yes;
    yes.data = true;
    if (in.data == 2) named_.publish(yes);
    std_msgs::Int32 more;
    more.data = in.data + 1;
    if (in.data > limit_) kept_.publish(more);
    always_.publish(in);
  }

  ros::NodeHandle nh_;
  ros::Publisher named_, kept_, always_;
  ros::Subscriber sub_, limit_sub_;
  int limit_ = 0;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
