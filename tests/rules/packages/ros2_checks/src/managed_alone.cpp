// A managed node that activates one of its publishers; a further one is used as what it derives from, which always sends.
#include <chrono>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_lifecycle/lifecycle_node.hpp>
#include <std_msgs/msg/string.hpp>

using Text = std_msgs::msg::String;
using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;

class Alone : public rclcpp_lifecycle::LifecycleNode {
public:
  Alone() : LifecycleNode("alone") {}

  CallbackReturn on_configure(const rclcpp_lifecycle::State &) override {
    forgotten_ = create_publisher<Text>("forgotten", 1);
    active_ = create_publisher<Text>("active", 1);
    plain_ = create_publisher<Text>("plain", 1);
    plain_->publish(Text());        // expect-not: finding publisher-inactive
    return CallbackReturn::SUCCESS;
  }
  CallbackReturn on_activate(const rclcpp_lifecycle::State &) override {
    active_->on_activate();
    timer_ = create_wall_timer(std::chrono::seconds(1), [this]() {
      forgotten_->publish(Text());  // expect: finding publisher-inactive "*/forgotten by a publisher that nothing activates*"
      active_->publish(Text());     // expect-not: finding publisher-inactive
      plain_->publish(Text());      // expect-not: finding publisher-inactive
    });
    return CallbackReturn::SUCCESS;
  }

private:
  rclcpp_lifecycle::LifecyclePublisher<Text>::SharedPtr forgotten_, active_;
  rclcpp::Publisher<Text>::SharedPtr plain_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Alone>()->get_node_base_interface());
}
