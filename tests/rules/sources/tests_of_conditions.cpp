// Functions that conditions call to ask for something: what they return stands for the call, when nothing else comes of it and it is about the same object.
// expect: 6 = count : { test_written(_, _, _) }
// expect: test_written(_, "ready()", F), function_name(F, "Node::ready")
// expect: test_written(_, "this->ready()", F), function_name(F, "Node::ready")
// expect: test_written(_, "deep()", F), function_name(F, "Node::deep")
// expect: test_written(R, "warned()", F), function_name(F, "Node::warned"), return_value(G, R), function_name(G, "Node::deep")
// expect: test_written(_, "info_.isSet()", F), function_name(F, "Info::isSet")
// expect: test_written(_, "once()", F), function_name(F, "Node::once")
#include <ros/ros.h>
#include <std_msgs/Empty.h>

struct Info {
  bool set_ = false;
  bool isSet() const { return set_; }
};

struct Lamp {
  bool lit_ = false;
  bool isLit() const { return lit_; }
};

struct Shape {
  virtual ~Shape() {}
  bool seen_ = false;
  bool isSeen() const { return seen_; }
};
struct Circle : Shape {};

struct Wheel {
  bool turning_ = false;
  bool isTurning() const { return turning_; }
};

struct Door {
  bool open_ = false;
  bool isOpen() const { return open_; }
};

class Node {
public:
  Node() {
    pub_ = nh_.advertise<std_msgs::Empty>("out", 1);
    sub_ = nh_.subscribe("in", 1, &Node::onIn, this);
    door_ = new Door;
  }

  bool ready() const { return ready_; }
  bool warned() {
    if (!ready_) return false;
    ROS_WARN("on");
    return true;
  }
  bool deep() { return warned(); }
  bool once() {
    do { ready(); } while (0);
    return ready_;
  }
  bool sends() { pub_.publish(std_msgs::Empty()); return true; }
  bool counts() { int n = 0; ++n; return n > 1; }
  bool loops() { for (int each : values_) { if (each) return true; } return false; }
  bool ofLocal() { int half = values_.size() / 2; return half > 1; }
  bool ofLambda() { return [this] { return ready_; }(); }
  bool tries() {
    try { pause(); } catch (...) { return false; }
    return ready_;
  }
  void pause() {}
  bool with(int n) { return n > 1; }

  void onIn(const std_msgs::Empty&) {
    if (ready()) ready_ = false;
    if (!this->ready()) ready_ = true;
    if (deep()) ready_ = false;
    if (once()) ready_ = false;
    if (sends()) ready_ = true;
    if (counts()) ready_ = false;
    if (loops()) ready_ = true;
    if (ofLocal()) ready_ = false;
    if (ofLambda()) ready_ = true;
    if (with(2)) ready_ = false;
    if (tries()) ready_ = true;
    if (info_.isSet()) ready_ = true;
    if (wheel_.isTurning()) ready_ = false;
    if (left_.isLit()) ready_ = false;
    if (shape_.isSeen()) ready_ = true;
    if (door_->isOpen()) ready_ = false;
  }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber sub_;
  bool ready_ = false;
  std::vector<int> values_;
  Info info_;
  Wheel wheel_;
  std::vector<Wheel> wheels_;
  Lamp left_, right_;
  Circle circle_;
  Shape shape_;
  Door *door_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
