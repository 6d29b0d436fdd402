// A node whose life others manage: what a transition does, and the ports that the library makes for it.
//
// expect: managed_node(C)
// expect: Count = count : { activity(F, "lifecycle") }, Count = 2
// expect: Count = count : { managed_node(C) }, Count = 1
// expect: service_server ~change_state lifecycle_msgs/ChangeState
// expect: publisher ~transition_event lifecycle_msgs/TransitionEvent
// expect: publisher driver/level std_msgs/Int32
// expect: enters(_, F), function_name(F, "Driver::poll")
// expect-only: transition *
// expect-only: reactive * -> *
// expect-only: periodic *
// expect: 8 = count : { activity_expr(_, _) }, 15 = count : { activity_part(_, _) }
#include <thread>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_lifecycle/lifecycle_node.hpp>
#include <std_msgs/msg/int32.hpp>

using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;

class Driver : public rclcpp_lifecycle::LifecycleNode {
public:
  Driver() : rclcpp_lifecycle::LifecycleNode("driver") {}

  CallbackReturn on_configure(const rclcpp_lifecycle::State &) override {
    level_ = 1;  // expect: transition level_ = 1 on lifecycle
    level_pub_ = create_publisher<std_msgs::msg::Int32>(std::string(get_name()) + "/level", 1);
    limit_sub_ = create_subscription<std_msgs::msg::Int32>("limit", 1, [this](const std_msgs::msg::Int32 &) {
      level_ = 3;  // expect: transition level_ = 3 on limit
    });
    set_up_ = true;
    help();
    return CallbackReturn::SUCCESS;
  }

  CallbackReturn on_activate(const rclcpp_lifecycle::State &) override {
    worker_ = std::thread([this]() { poll(); });
    return CallbackReturn::SUCCESS;
  }

  CallbackReturn on_cleanup(const rclcpp_lifecycle::State &) override;

private:
  void help() {
    if (level_ == 1) level_ = 2;  // expect: transition level_ = 2 on lifecycle
  }

  void poll() {
    rclcpp::Rate rate(4);
    while (rclcpp::ok()) {
      if (set_up_ && level_ > 1) level_pub_->publish(std_msgs::msg::Int32());
      rate.sleep();  // expect: periodic driver/level 4 Hz
    }
  }

  int level_ = 0;
  bool set_up_ = false;
  rclcpp::Subscription<std_msgs::msg::Int32>::SharedPtr limit_sub_;
  std::thread worker_;
  rclcpp_lifecycle::LifecyclePublisher<std_msgs::msg::Int32>::SharedPtr level_pub_;
};

class Unused : public rclcpp_lifecycle::LifecycleNode {
public:
  Unused() : rclcpp_lifecycle::LifecycleNode("unused") {}
  CallbackReturn on_configure(const rclcpp_lifecycle::State &) override { return CallbackReturn::SUCCESS; }
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Driver>()->get_node_base_interface());
}
