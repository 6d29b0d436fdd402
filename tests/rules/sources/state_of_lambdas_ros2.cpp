// A node all of whose changes are written in lambdas of its constructor.
//
// expect: state Sender::sent_ = 0
// expect: transition Sender::sent_ = sent_++
// expect: transition Sender::ready_ = true
// expect: state Sender::ready_ = false
// expect-only: state
// expect: periodic setpoint hz=10
#include <chrono>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>

using namespace std::chrono_literals;

class Sender : public rclcpp::Node
{
public:
  Sender() : Node("sender")
  {
    setpoint_ = create_publisher<std_msgs::msg::Bool>("setpoint", 10);
    sent_ = 0;
    ready_sub_ = create_subscription<std_msgs::msg::Bool>("ready", 1, [this](std_msgs::msg::Bool::SharedPtr) { ready_ = true; });
    auto tick = [this]() -> void {
      if (ready_ && sent_ < 11) {
        send();
        sent_++;
      }
    };
    timer_ = create_wall_timer(100ms, tick);
  }

private:
  void send() { setpoint_->publish(std_msgs::msg::Bool()); }

  bool ready_ = false;
  uint64_t sent_;
  rclcpp::TimerBase::SharedPtr timer_;
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr setpoint_;
  rclcpp::Subscription<std_msgs::msg::Bool>::SharedPtr ready_sub_;
};

int main(int argc, char** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Sender>());
}
