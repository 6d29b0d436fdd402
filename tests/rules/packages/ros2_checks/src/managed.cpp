// Publishers of a managed node: one is used too early, all are activated by the node's base class.
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_lifecycle/lifecycle_node.hpp>
#include <std_msgs/msg/string.hpp>

using Text = std_msgs::msg::String;
using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;

class Managed : public rclcpp_lifecycle::LifecycleNode {
public:
  Managed() : LifecycleNode("managed") {}

  CallbackReturn on_configure(const rclcpp_lifecycle::State &) override {
    state_ = create_publisher<Text>("state", 1);
    state_->publish(Text());  // expect: finding publisher-inactive "/managed publishes /state before it can be active: the message is dropped"
    report();
    return CallbackReturn::SUCCESS;
  }
  CallbackReturn on_activate(const rclcpp_lifecycle::State & previous) override {
    LifecycleNode::on_activate(previous);
    state_->publish(Text());  // expect-not: finding publisher-inactive
    report();
    return CallbackReturn::SUCCESS;
  }

private:
  void report() { state_->publish(Text()); }  // expect-not: finding publisher-inactive
  rclcpp_lifecycle::LifecyclePublisher<Text>::SharedPtr state_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Managed>()->get_node_base_interface());
}
