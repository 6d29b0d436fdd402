// Members that are changed by another name: a pointer or reference that is chosen, an iterator, a binding, a wrapper, what a function gives, a guard.
// expect: assignment(E, V, "argument"), location(E, _, 60, _), variable_name(V, "left_")
// expect: assignment(E, V, "argument"), location(E, _, 60, _), variable_name(V, "right_")
// expect: 9 = count : { changes_by_other_name(E, V), variable_name(V, "left_") }
// expect-not: changes_by_other_name(_, V), variable_name(V, "other_")
// expect-not: changes_by_other_name(_, V), variable_name(V, "copied_")
// expect-not: assignment(_, V, _), variable_name(V, "window_")
// expect: assignment(E, V, "argument"), location(E, _, 65, _), variable_name(V, "found_")
// expect: assignment(E, V, "argument"), location(E, _, 67, _), variable_name(V, "pair_")
// expect: assignment(E, V, "argument"), location(E, _, 72, _), variable_name(V, "list_")
// expect: member_refers(W, V), variable_name(W, "wrapped_"), variable_name(V, "left_")
// expect: runs_at_end(C, _), location(C, _, 73, _)
// expect: may_be_missed(E), location(E, _, 81, _)
// expect-not: may_be_missed(E), location(E, _, 83, _)
// expect: port_flow([_, "subscriber", "set"], [_, "publisher", "out"], "control", "kept")
#include <algorithm>
#include <cstring>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>

using std_msgs::msg::Bool;

struct Guard {
  explicit Guard(bool & flag) : flag_(flag) {}
  ~Guard() { flag_ = true; }
  bool & flag_;
};

class Node : public rclcpp::Node {
public:
  Node() : rclcpp::Node("node") {
    out_ = create_publisher<Bool>("out", 1);
    set_ = create_subscription<Bool>("set", 1, [this](Bool::ConstSharedPtr m) { onSet(*m); });
    in_ = create_subscription<Bool>("in", 1, [this](Bool::ConstSharedPtr m) { onIn(*m); });
  }

private:
  bool & pick(bool first) { return first ? left_ : right_; }
  void put(bool * flag) { *flag = true; }
  void check(bool bad) {
    if (bad) throw std::runtime_error("bad");
  }
  void onIn(const Bool & m) {
    if (left_ || right_ || other_ || found_[1] || pair_.first || list_[1] || copied_) out_->publish(m);
  }
  void onSet(const Bool & m) {
    bool copy = copied_;
    copy = true;
    const bool & seen = other_;
    (void)seen;
    (void)copy;
    bool * chosen = m.data ? &left_ : &right_;
    *chosen = true;
    (m.data ? left_ : right_) = true;
    pick(m.data) = true;
    put(&left_);
    auto it = found_.find(1);
    if (it != found_.end()) it->second = true;
    auto & [on, count] = pair_;
    on = true;
    wrapped_.get() = true;
    Guard guard(left_);
    bool & named = left_;
    auto later = [&named] { named = true; };
    std::memset(list_, 1, sizeof(list_));
    std::shared_ptr<void> end(nullptr, [this](void *) { ended_ = true; });
    later();
    std::tie(left_, number_) = std::make_pair(true, count);
    bool * none = nullptr;
    if (m.data) none = &left_;
    if (none) *none = true;
    try {
      check(m.data);
      checked_ = true;
    } catch (const std::exception &) {
      checked_ = false;
    }
    if (checked_ && ended_) out_->publish(m);
    std::vector<int> sorted(window_.begin(), window_.end());
    std::sort(sorted.begin(), sorted.end());
    if (!window_.empty() && sorted[0] > 0) out_->publish(m);
  }

  bool left_ = false, right_ = false, other_ = false, copied_ = false, ended_ = false, checked_ = false;
  int number_ = 0;
  bool list_[3] = {false, false, false};
  std::map<int, bool> found_;
  std::deque<int> window_;
  std::pair<bool, int> pair_{false, 0};
  std::reference_wrapper<bool> wrapped_{left_};
  rclcpp::Publisher<Bool>::SharedPtr out_;
  rclcpp::SubscriptionBase::SharedPtr set_, in_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Node>());
}
