// What functions are called with, where it means the same throughout the function.
// expect: 5 = count : { argument_given(_, _, _, _) }
// expect: argument_given(_, _, "mode", A), expr_text(A, "3")
// expect: argument_given(_, _, "mode", A), expr_text(A, "m.data")
// expect: argument_given(_, _, "from", A), expr_text(A, "limit_")
// expect: argument_given(_, _, "by", A), expr_text(A, "5")
// expect: argument_given(_, _, "by", A), expr_text(A, "6")
#include <ros/ros.h>
#include <std_msgs/Int32.h>

class Node {
public:
  Node() { sub_ = nh_.subscribe("in", 1, &Node::onIn, this); }

  void set(int mode) { if (mode != mode_) mode_ = mode; }
  void add(int amount) { amount = amount % 10; mode_ = amount; }
  void jump(int from, int by = 5) { mode_ = 0; if (from > by) mode_ = by; }
  int next() { return mode_ + 1; }

  void onIn(const std_msgs::Int32& m) {
    set(3);
    set(m.data);
    set(next());
    set(abs(m.data));
    add(4);
    jump(mode_);
    jump(limit_, 6);
  }

  ros::NodeHandle nh_;
  ros::Subscriber sub_;
  int mode_ = 0, limit_ = 9;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
