// Timers that their own callbacks stop, and threads of callbacks and of the program.
// expect-only: reactive * -> *
// expect-only: one_shot *
// expect-only: periodic *
// expect: 3 = count : { enters(_, _) }
#include <chrono>
#include <thread>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>

using Text = std_msgs::msg::String;
using namespace std::chrono_literals;

class Clock : public rclcpp::Node {
public:
  Clock() : Node("clock") {
    late_ = create_publisher<Text>("late", 1);
    often_ = create_publisher<Text>("often", 1);
    start_ = create_subscription<Text>("start", 1, [this](const Text &) {
      once_ = create_wall_timer(500ms, [this]() { late_->publish(Text()); once_->cancel(); });  // expect: one_shot late 0.5 s
      std::thread([this]() { helper(); }).detach();
    });
    // expect: reactive start -> often may
    tick_ = create_wall_timer(std::chrono::milliseconds(100), [this]() {  // expect: periodic often 10 Hz
      often_->publish(Text());
      if (++count_ > 5) tick_->cancel();
    });
    worker_ = std::thread([this]() { late_->publish(Text()); });
  }

private:
  void helper() { often_->publish(Text()); }
  int count_ = 0;
  std::thread worker_;
  rclcpp::Publisher<Text>::SharedPtr late_, often_;
  rclcpp::TimerBase::SharedPtr once_, tick_;
  rclcpp::Subscription<Text>::SharedPtr start_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Clock>());
}
