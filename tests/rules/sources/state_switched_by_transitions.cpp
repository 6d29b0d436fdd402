// Variables that transitions of a node's life set: switched between constants they are state, else what the node is configured with.
//
// expect: state Driver::active_ = false
// expect-only: state
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_lifecycle/lifecycle_node.hpp>
#include <std_msgs/msg/int32.hpp>

using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;

class Driver : public rclcpp_lifecycle::LifecycleNode
{
public:
  Driver() : rclcpp_lifecycle::LifecycleNode("driver") {}

  CallbackReturn on_configure(const rclcpp_lifecycle::State &) override
  {
    loud_ = true;
    limit_ = declare_parameter("limit", 3);
    level_pub_ = create_publisher<std_msgs::msg::Int32>("level", 1);
    timer_ = create_wall_timer(std::chrono::milliseconds(100), [this]() {
      if (active_ && loud_ && limit_ > 1) level_pub_->publish(std_msgs::msg::Int32());
    });
    return CallbackReturn::SUCCESS;
  }

  CallbackReturn on_activate(const rclcpp_lifecycle::State &) override
  {
    active_ = true;  // expect: transition active_ = true on lifecycle
    return CallbackReturn::SUCCESS;
  }

  CallbackReturn on_deactivate(const rclcpp_lifecycle::State &) override
  {
    active_ = false;  // expect: transition active_ = false on lifecycle
    limit_ = 0;
    return CallbackReturn::SUCCESS;
  }

private:
  bool active_ = false;
  bool loud_ = false;
  int limit_ = 0;
  rclcpp_lifecycle::LifecyclePublisher<std_msgs::msg::Int32>::SharedPtr level_pub_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Driver>()->get_node_base_interface());
}
