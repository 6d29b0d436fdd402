// A part of a time counts in the unit that the time has.
//
// expect: periodic one 50 Hz
// expect: periodic two 4 Hz
// expect: periodic four 8 Hz
#include <chrono>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/empty.hpp>

using namespace std::chrono_literals;

class N : public rclcpp::Node {
public:
  N() : Node("n") {
    double freq = declare_parameter("freq", 50.0);
    one_ = create_publisher<std_msgs::msg::Empty>("one", 1);
    two_ = create_publisher<std_msgs::msg::Empty>("two", 1);
    a_ = create_wall_timer(1s / freq, [=]() { one_->publish(std_msgs::msg::Empty()); });
    four_ = create_publisher<std_msgs::msg::Empty>("four", 1);
    d_ = create_wall_timer(std::chrono::milliseconds(500) / 4, [=]() { four_->publish(std_msgs::msg::Empty()); });
    b_ = create_wall_timer(1000ms / 4, [=]() { two_->publish(std_msgs::msg::Empty()); });
  }

private:
  rclcpp::Publisher<std_msgs::msg::Empty>::SharedPtr one_, two_, four_;
  rclcpp::TimerBase::SharedPtr a_, b_, d_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<N>());
}
