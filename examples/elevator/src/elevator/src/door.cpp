// The door: a node whose life is managed. It opens while the cabin is at its floor, and tells so while it is active.
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "std_msgs/msg/bool.hpp"
#include "std_msgs/msg/int32.hpp"

using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;

class Door : public rclcpp_lifecycle::LifecycleNode
{
public:
  Door() : LifecycleNode("door") { declare_parameter("floor", 0); }

  CallbackReturn on_configure(const rclcpp_lifecycle::State &) override
  {
    own_floor_ = get_parameter("floor").as_int();
    open_pub_ = create_publisher<std_msgs::msg::Bool>("~/open", 1);
    floor_sub_ = create_subscription<std_msgs::msg::Int32>(
      "floor", rclcpp::QoS(1).transient_local(), [this](std_msgs::msg::Int32::ConstSharedPtr floor) { onFloor(floor->data); });
    return CallbackReturn::SUCCESS;
  }

  CallbackReturn on_activate(const rclcpp_lifecycle::State & state) override
  {
    LifecycleNode::on_activate(state);
    return CallbackReturn::SUCCESS;
  }

private:
  void onFloor(int floor)
  {
    const bool open = floor == own_floor_;
    if (open != open_) {
      open_ = open;
      std_msgs::msg::Bool message;
      message.data = open_;
      open_pub_->publish(message);
    }
  }

  int own_floor_ = 0;
  bool open_ = false;
  rclcpp_lifecycle::LifecyclePublisher<std_msgs::msg::Bool>::SharedPtr open_pub_;
  rclcpp::Subscription<std_msgs::msg::Int32>::SharedPtr floor_sub_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto door = std::make_shared<Door>();
  rclcpp::spin(door->get_node_base_interface());
  rclcpp::shutdown();
  return 0;
}
