// expect: held_up a callback sleeps
// expect: unheard short what holds it goes out of scope
// expect: unheard slow a callback sleeps
#include <ros/ros.h>
#include <std_msgs/Empty.h>

class Node {
public:
  Node() {
    pub_ = nh_.advertise<std_msgs::Empty>("out", 1);
    slow_ = nh_.subscribe("slow", 1, &Node::onSlow, this);
    ros::Subscriber gone = nh_.subscribe("short", 1, &Node::onShort, this);
  }

private:
  void onSlow(const std_msgs::Empty& msg) {
    ros::Duration(0.1).sleep();
    pub_.publish(msg);
  }
  void onShort(const std_msgs::Empty& msg) { pub_.publish(msg); }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber slow_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
