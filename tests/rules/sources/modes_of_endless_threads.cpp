// What a thread that never ends makes of a mode: nothing decides whether its loop is come to.
//
// expect: moves_freely(V, "false", "true"), variable_name(V, "receiving_")
// expect: moves_freely(V, "true", "false"), variable_name(V, "receiving_")
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/empty.hpp>

#include <thread>

class Driver : public rclcpp::Node {
 public:
  Driver() : Node("driver") {
    pub_ = create_publisher<std_msgs::msg::Empty>("alive", 1);
    timer_ = create_wall_timer(std::chrono::seconds(1), [this]() {
      if (receiving_) pub_->publish(std_msgs::msg::Empty());
      receiving_ = false;
    });
    thread_ = std::thread([this]() {
      for (;;) {
        read();
      }
    });
  }

 private:
  void read() {
    if (!receiving_) receiving_ = true;
  }

  rclcpp::Publisher<std_msgs::msg::Empty>::SharedPtr pub_;
  rclcpp::TimerBase::SharedPtr timer_;
  std::thread thread_;
  bool receiving_ = false;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Driver>());
}
