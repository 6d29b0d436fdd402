// expect: 16 off: 20 on perhaps, 25 off perhaps
// expect: 21 off: 21 on, 26 off, 33 off if !(timer_ && timer_->is_canceled())
#include <chrono>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_lifecycle/lifecycle_node.hpp>
#include <std_msgs/msg/float64.hpp>

using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;

class Sensor : public rclcpp_lifecycle::LifecycleNode {
public:
  Sensor() : LifecycleNode("sensor") {}

  CallbackReturn on_configure(const rclcpp_lifecycle::State&) override {
    sub_ = create_subscription<std_msgs::msg::Float64>("off", 1, [this](const std_msgs::msg::Float64&) { onOff(); });
    pub_ = create_publisher<std_msgs::msg::Float64>("value", 10);
    return CallbackReturn::SUCCESS;
  }
  CallbackReturn on_activate(const rclcpp_lifecycle::State&) override {
    pub_->on_activate();
    timer_ = create_wall_timer(std::chrono::milliseconds(100), [this] { pub_->publish(std_msgs::msg::Float64()); });
    return CallbackReturn::SUCCESS;
  }
  CallbackReturn on_deactivate(const rclcpp_lifecycle::State&) override {
    pub_->on_deactivate();
    timer_.reset();
    return CallbackReturn::SUCCESS;
  }

private:
  void onOff() {
    if (timer_ && timer_->is_canceled()) return;
    timer_ = nullptr;
  }
  rclcpp_lifecycle::LifecyclePublisher<std_msgs::msg::Float64>::SharedPtr pub_;
  rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr sub_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Sensor>()->get_node_base_interface());
}
