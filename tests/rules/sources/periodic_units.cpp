// Periods that are made from other times: the unit is that of the time whose number it is.
//
// expect: periodic of_rate 5 Hz mechanism=timer
// expect: periodic of_milliseconds 10 Hz mechanism=timer
// expect: periodic of_seconds 4 Hz mechanism=timer
// expect: periodic cast 20 Hz mechanism=timer
// expect: periodic named 8 Hz mechanism=timer
// expect-only: periodic
#include <chrono>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/empty.hpp>

using namespace std::chrono_literals;

class Timed : public rclcpp::Node
{
public:
  Timed() : Node("timed")
  {
    of_rate_ = create_publisher<std_msgs::msg::Empty>("of_rate", 1);
    of_milliseconds_ = create_publisher<std_msgs::msg::Empty>("of_milliseconds", 1);
    of_seconds_ = create_publisher<std_msgs::msg::Empty>("of_seconds", 1);
    named_ = create_publisher<std_msgs::msg::Empty>("named", 1);
    cast_ = create_publisher<std_msgs::msg::Empty>("cast", 1);
    timers_[0] = create_wall_timer(rclcpp::Rate(5.0).period(), [this]() { of_rate_->publish(std_msgs::msg::Empty()); });
    timers_[1] = rclcpp::create_timer(this, get_clock(), rclcpp::Duration(100ms), [this]() { of_milliseconds_->publish(std_msgs::msg::Empty()); });
    timers_[2] = rclcpp::create_timer(this, get_clock(), rclcpp::Duration::from_seconds(0.25), [this]() { of_seconds_->publish(std_msgs::msg::Empty()); });
    timers_[3] = create_wall_timer(std::chrono::duration_cast<std::chrono::nanoseconds>(50ms), [this]() { cast_->publish(std_msgs::msg::Empty()); });
    const auto period = rclcpp::Rate(8).period();
    timers_[4] = create_wall_timer(period, [this]() { named_->publish(std_msgs::msg::Empty()); });
  }

private:
  rclcpp::Publisher<std_msgs::msg::Empty>::SharedPtr of_rate_, of_milliseconds_, of_seconds_, cast_, named_;
  rclcpp::TimerBase::SharedPtr timers_[5];
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Timed>());
}
