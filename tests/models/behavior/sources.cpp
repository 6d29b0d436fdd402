// A helper that callbacks tell which of them calls: what it compares this with is decided for each of them.
#include <ros/ros.h>
#include <std_msgs/Empty.h>

enum class Source { NONE, NAV, JOY };

class Node {
public:
  Node() : locked_(false), active_(Source::NONE) {
    pub_ = nh_.advertise<std_msgs::Empty>("out", 1);
    nav_ = nh_.subscribe("nav", 1, &Node::onNav, this);
    joy_ = nh_.subscribe("joy", 1, &Node::onJoy, this);
    lock_ = nh_.subscribe("lock", 1, &Node::onLock, this);
  }

private:
  void handle(Source source) {
    if (locked_) return;
    if (source == Source::NAV && active_ == Source::JOY) return;
    active_ = source;
    pub_.publish(std_msgs::Empty());
  }
  void onNav(const std_msgs::Empty&) { handle(Source::NAV); }
  void onJoy(const std_msgs::Empty&) { handle(Source::JOY); }
  void onLock(const std_msgs::Empty&) { locked_ = true; }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber nav_, joy_, lock_;
  bool locked_;
  Source active_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}

// expect: reactive joy -> out may [!locked_]
// expect: reactive nav -> out may [!locked_ && !(source == Source::NAV && active_ == Source::JOY)]
// expect: state Node::active_ = Source::NONE
// expect: state Node::locked_ = false
// expect: transition Node::active_ . None on joy [!locked_] := Source::JOY
// expect: transition Node::active_ . None on nav [!locked_ && !(source == Source::NAV && active_ == Source::JOY)] := Source::NAV
// expect: transition Node::locked_ . None on lock [] := true
// normal: reactive joy -> out [!locked_]
// normal: reactive nav -> out [!locked_ && active_ != Source::JOY]
// normal: transition Node::active_ on joy [!locked_]
// normal: transition Node::active_ on nav [!locked_ && active_ != Source::JOY]
// normal: transition Node::locked_ on lock []
