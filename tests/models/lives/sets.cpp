// expect: perhaps_always fault siren
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Empty.h>

// each fault sounds the siren: it sets what the timer asks for; a message may mute it, or not
class Node {
public:
  Node() {
    siren_ = nh_.advertise<std_msgs::Empty>("siren", 1);
    fault_ = nh_.subscribe("fault", 1, &Node::onFault, this);
    mute_ = nh_.subscribe("mute", 1, &Node::onMute, this);
    timer_ = nh_.createTimer(ros::Duration(0.5), &Node::onTimer, this);
  }

private:
  void onFault(const std_msgs::Empty&) { alarms_ = 8; }
  void onMute(const std_msgs::Bool& msg) { muted_ = msg.data; }

  void onTimer(const ros::TimerEvent&) {
    if (alarms_ > 0 && !muted_) {
      --alarms_;
      siren_.publish(std_msgs::Empty());
    }
  }

  ros::NodeHandle nh_;
  ros::Publisher siren_;
  ros::Subscriber fault_, mute_;
  ros::Timer timer_;
  int alarms_ = 0;
  bool muted_ = false;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
