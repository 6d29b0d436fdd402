// Timers that wait: longer than their period, for a short while, under a condition.
#include <chrono>
#include <thread>
#include <rclcpp/rclcpp.hpp>

using namespace std::chrono_literals;

class Slow : public rclcpp::Node {
public:
  Slow() : Node("slow") {
    late_ = create_wall_timer(100ms, [this]() { step(); });
    fine_ = create_wall_timer(1s, []() { std::this_thread::sleep_for(100ms); });  // expect-not: finding timer-overrun
    rare_ = create_wall_timer(100ms, std::bind(&Slow::sometimes, this));
  }

private:
  void step() {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));  // expect: finding timer-overrun "the callback of a timer of /slow waits 200.0 ms each time, but the timer is to run every 100.0 ms"
  }
  void sometimes() {
    if (++count_ % 100 == 0) rclcpp::sleep_for(std::chrono::seconds(1));  // expect-not: finding timer-overrun
  }
  int count_ = 0;
  rclcpp::TimerBase::SharedPtr late_, fine_, rare_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Slow>());
}
