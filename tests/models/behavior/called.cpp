// Conditions that call tests, and functions that are called with other values from call to call.
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Empty.h>

enum class Mode { IDLE, RUN };

class Info {
public:
  void set() { set_ = true; }
  bool isSet() const { return set_; }

private:
  bool set_ = false;
};

class Lamp {
public:
  void light() { lit_ = true; }
  bool isLit() const { return lit_; }

private:
  bool lit_ = false;
};

class Node {
public:
  Node() : ready_(false), mode_(Mode::IDLE) {
    pub_ = nh_.advertise<std_msgs::Empty>("out", 1);
    start_ = nh_.subscribe("start", 1, &Node::onStart, this);
    get_ = nh_.subscribe("get", 1, &Node::onGet, this);
    check_ = nh_.subscribe("check", 1, &Node::onCheck, this);
    counted_ = nh_.subscribe("counted", 1, &Node::onCounted, this);
    object_ = nh_.subscribe("object", 1, &Node::onObject, this);
    lamps_ = nh_.subscribe("lamps", 1, &Node::onLamps, this);
    switch_ = nh_.subscribe("switch", 1, &Node::onSwitch, this);
    toggle_ = nh_.subscribe("toggle", 1, &Node::onToggle, this);
  }

private:
  bool isReady() const { return ready_; }
  bool check() {
    if (!ready_) {
      ROS_WARN("not ready");
      return false;
    }
    return mode_ == Mode::RUN;
  }
  bool counted() { return ++calls_ > 3; }

  void setMode(Mode mode) {
    if (mode == mode_) return;
    mode_ = mode;
    pub_.publish(std_msgs::Empty());
  }
  void set(Mode mode) { setMode(mode); }
  void allow(bool allowed) {
    if (allowed) ready_ = true;
  }

  void onStart(const std_msgs::Empty&) {
    allow(true);
    info_.set();
    left_.light();
  }
  void onGet(const std_msgs::Empty& m) {
    if (isReady()) pub_.publish(m);
  }
  void onCheck(const std_msgs::Empty& m) {
    if (!check()) return;
    pub_.publish(m);
  }
  void onCounted(const std_msgs::Empty& m) {
    if (counted()) pub_.publish(m);
  }
  void onObject(const std_msgs::Empty& m) {
    if (info_.isSet()) pub_.publish(m);
  }
  void onLamps(const std_msgs::Empty& m) {
    if (left_.isLit() && right_.isLit()) pub_.publish(m);
  }
  void onSwitch(const std_msgs::Bool& m) { set(m.data ? Mode::RUN : Mode::IDLE); }
  void onToggle(const std_msgs::Bool& m) {
    if (m.data) set(Mode::RUN);
    else set(Mode::IDLE);
    allow(false);
  }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber start_, get_, check_, counted_, object_, lamps_, switch_, toggle_;
  bool ready_;
  int calls_ = 0;
  Mode mode_;
  Info info_;
  Lamp left_, right_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
// expect: reactive check -> out may [!(!check())]
// expect: reactive counted -> out may [counted()]
// expect: reactive get -> out may [isReady()]
// expect: reactive lamps -> out may [left_.isLit() && right_.isLit()]
// expect: reactive object -> out may [info_.isSet()]
// expect: reactive switch -> out may [!(mode == mode_)]
// expect: reactive toggle -> out may [(m.data && !(mode == mode_)) || (!m.data && !(mode == mode_))]
// expect: state Info::set_ = false
// expect: state Lamp::lit_ = false
// expect: state Node::calls_ = 0
// expect: state Node::mode_ = Mode::IDLE
// expect: state Node::ready_ = false
// expect: transition Info::set_ . None on start [] := true
// expect: transition Lamp::lit_ . None on start [] := true
// expect: transition Node::calls_ . None on counted [] := ++calls_
// expect: transition Node::mode_ . None on switch [!(mode == mode_)] := mode
// expect: transition Node::mode_ . None on toggle [!m.data && !(mode == mode_)] := Mode::IDLE
// expect: transition Node::mode_ . None on toggle [m.data && !(mode == mode_)] := Mode::RUN
// expect: transition Node::ready_ . None on start [] := true
// normal: reactive check -> out [ready_ && mode_ == Mode::RUN]
// normal: reactive counted -> out [counted()]
// normal: reactive get -> out [ready_]
// normal: reactive lamps -> out [left_.isLit() && right_.isLit()]
// normal: reactive object -> out [set_]
// normal: reactive switch -> out [(m.data ? Mode::RUN : Mode::IDLE) != mode_]
// normal: reactive toggle -> out [(m.data && mode_ != Mode::RUN) || (!m.data && mode_ != Mode::IDLE)]
// normal: transition Info::set_ on start []
// normal: transition Lamp::lit_ on start []
// normal: transition Node::calls_ on counted []
// normal: transition Node::mode_ on switch [(m.data ? Mode::RUN : Mode::IDLE) != mode_]
// normal: transition Node::mode_ on toggle [!m.data && mode_ != Mode::IDLE]
// normal: transition Node::mode_ on toggle [m.data && mode_ != Mode::RUN]
// normal: transition Node::ready_ on start []
