// Objects of one class are told apart by the variables that hold them: what one keeps is not what another does. Not where it is not known which object is meant.
// expect: port_flow([_, "subscriber", "left"], [_, "publisher", "left_out"], "control", "kept")
// expect-not: port_flow([_, "subscriber", "right"], [_, "publisher", "left_out"], _, _)
// expect: port_flow([_, "subscriber", "right"], [_, "publisher", "right_out"], "control", "kept")
// expect: port_flow([_, "subscriber", "either"], [_, "publisher", "left_out"], "control", "kept")
// expect: port_flow([_, "subscriber", "front"], [_, "publisher", "back_out"], "control", "kept")
// expect: port_flow([_, "subscriber", "by_way"], [_, "publisher", "left_out"], _, "kept")
// a message that is sent, and what sends it, are no longer changed
// expect-not: port_flow([_, "subscriber", "plain"], [_, "publisher", "first_out"], _, _)
// expect: port_flow([_, "subscriber", "plain"], [_, "publisher", "second_out"], "control", "kept")
#include <memory>
#include <ros/ros.h>
#include <std_msgs/Bool.h>

typedef std_msgs::Bool M;

class Gate {
public:
  bool isOpen() const { return open_; }
  void set(bool open) { open_ = open; }

private:
  bool open_ = false;
};

class Door {
public:
  bool isOpen() const { return open_; }
  void set(bool open) { open_ = open; }

private:
  bool open_ = false;
};

struct Part {
  bool ready = false;
  bool isReady() const { return ready; }
};

class Node {
public:
  Node() : right_(std::make_unique<Gate>()), left_(std::make_unique<Gate>()) {
    left_out_ = nh_.advertise<M>("left_out", 1);
    right_out_ = nh_.advertise<M>("right_out", 1);
    back_out_ = nh_.advertise<M>("back_out", 1);
    first_out_ = nh_.advertise<M>("first_out", 1);
    second_out_ = nh_.advertise<M>("second_out", 1);
    subs_[0] = nh_.subscribe("left", 1, &Node::onLeft, this);
    subs_[1] = nh_.subscribe("right", 1, &Node::onRight, this);
    subs_[2] = nh_.subscribe("either", 1, &Node::onEither, this);
    subs_[3] = nh_.subscribe("front", 1, &Node::onFront, this);
    subs_[4] = nh_.subscribe("ask_left", 1, &Node::onAskLeft, this);
    subs_[5] = nh_.subscribe("ask_right", 1, &Node::onAskRight, this);
    subs_[6] = nh_.subscribe("ask_back", 1, &Node::onAskBack, this);
    subs_[7] = nh_.subscribe("by_way", 1, &Node::onByWay, this);
    subs_[8] = nh_.subscribe("take", 1, &Node::onTake, this);
    subs_[9] = nh_.subscribe("plain", 1, &Node::onPlain, this);
    subs_[10] = nh_.subscribe("ask_plain", 1, &Node::onAskPlain, this);
  }

private:
  void onLeft(const M& m) { left_->set(m.data); }
  void onRight(const M& m) { right_->set(m.data); }
  void onEither(const M& m) {
    Gate* gate = m.data ? left_.get() : right_.get();
    gate->set(true);
  }
  void onAskLeft(const M& m) {
    if (left_->isOpen()) left_out_.publish(m);
  }
  void onAskRight(const M& m) {
    if (right_->isOpen()) right_out_.publish(m);
  }
  // ... by way of a variable of the node
  void onByWay(const M& m) { kept_ = m.data; }
  void onTake(const M&) { left_->set(kept_); }
  // one is copied to the other
  void onFront(const M& m) {
    front_.set(m.data);
    back_ = front_;
  }
  void onAskBack(const M& m) {
    if (back_.isOpen()) back_out_.publish(m);
  }
  void onPlain(const M&) { second_.ready = true; }
  void onAskPlain(const M& m) {
    if (first_.isReady()) first_out_.publish(m);
    if (second_.isReady()) second_out_.publish(m);
  }

  ros::NodeHandle nh_;
  std::unique_ptr<Gate> right_, left_;
  Door front_, back_;
  Part first_, second_;
  bool kept_ = false;
  ros::Publisher left_out_, right_out_, back_out_, first_out_, second_out_;
  ros::Subscriber subs_[11];
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
