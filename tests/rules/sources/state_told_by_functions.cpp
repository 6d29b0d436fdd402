// What functions return tells of the state that it hangs on: nothing, a list with a constant, what is made of an argument.
//
// expect: state Fuser::arrived_
// expect: state Fuser::queue_
// expect: state Robot::calling_
// expect: state Kept::parts_
// expect-only: state
// expect: transition Fuser::queue_ on /in
// expect: transition Fuser::arrived_ = true on /first
// expect: 4 = count : { constant_return(_, _) }
#include <deque>
#include <optional>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/int32.hpp>

using Int = std_msgs::msg::Int32;

class Fuser {
public:
  void start() { arrived_ = true; }
  std::optional<Int> fuse(const Int & message) {
    queue_.push_back(message);
    last_ = message.data;
    if (!arrived_) return std::nullopt;
    if (queue_.empty()) return std::nullopt;
    return queue_.front();
  }

private:
  bool arrived_{false};
  int last_{0};
  std::deque<Int> queue_;
};

enum class Action { Wait, Call };

struct Decision {
  Action action;
  int count;
};

Decision decide(int count, bool calling) {
  if (calling) return {Action::Wait, count};
  return {Action::Call, 0};
}

// made for an object that ends with the callback
class Built {
public:
  explicit Built(int parts) { add(parts); }
  void add(int parts) { parts_ += parts; }
  bool whole() const { return parts_ > 3; }

private:
  int parts_{0};
};

struct Builder {
  explicit Builder(int parts) : built_(std::make_unique<Built>(parts)) { built_->add(1); }
  std::unique_ptr<Built> built_;
};

class Kept {
public:
  void add() { ++parts_; }
  bool whole() const { return parts_ > 3; }

private:
  int parts_{0};
};

class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") {
    pub_ = create_publisher<Int>("/out", 1);
    called_ = create_publisher<Int>("/called", 1);
    first_ = create_subscription<Int>("/first", 1, [this](const Int &) { fuser_.start(); });
    kept_ = std::make_unique<Kept>();
    sub_ = create_subscription<Int>("/in", 1, [this](const Int & message) {
      const auto fused = fuser_.fuse(message);
      const Builder builder(message.data);
      if (builder.built_->whole()) pub_->publish(message);
      kept_->add();
      if (kept_->whole()) pub_->publish(message);
      if (fused) pub_->publish(*fused);
    });
    timer_ = create_wall_timer(std::chrono::seconds(1), [this]() { tick(); });
  }

private:
  void tick() {
    const auto decision = decide(3, calling_);
    if (decision.action == Action::Call) {
      calling_ = true;
      called_->publish(Int());
    }
  }

  bool calling_{false};
  Fuser fuser_;
  std::unique_ptr<Kept> kept_;
  rclcpp::Publisher<Int>::SharedPtr pub_, called_;
  rclcpp::Subscription<Int>::SharedPtr first_, sub_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
}
