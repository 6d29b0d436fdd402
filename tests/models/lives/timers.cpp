// expect: unsteady 14 it is made stopped
// expect: unsteady 14 something is done with it later
// expect: unsteady 20 it is not made in any case when the node begins
// expect: unsteady 20 something is done with it later
#include <ros/ros.h>
#include <std_msgs/Empty.h>

class Node {
public:
  Node() {
    pub_ = nh_.advertise<std_msgs::Empty>("out", 1);
    start_ = nh_.subscribe("start", 1, &Node::onStart, this);
    steady_ = nh_.createTimer(ros::Duration(0.1), &Node::tick, this);
    waiting_ = nh_.createTimer(ros::Duration(0.2), &Node::tick, this, false, false);
    nh_.createTimer(ros::Duration(0.3), &Node::tick, this);
  }

private:
  void onStart(const std_msgs::Empty&) {
    late_ = nh_.createTimer(ros::Duration(0.4), &Node::tick, this);
    waiting_.start();
    late_.start();
  }
  void tick(const ros::TimerEvent&) { pub_.publish(std_msgs::Empty()); }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber start_;
  ros::Timer steady_, waiting_, late_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
