// The panel: one program with two nodes, buttons that people press and a display that shows the floor.
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/int32.hpp"
#include "std_msgs/msg/string.hpp"

class Buttons : public rclcpp::Node
{
public:
  Buttons() : Node("buttons")
  {
    call_pub_ = create_publisher<std_msgs::msg::Int32>("call", 5);
    pressed_sub_ = create_subscription<std_msgs::msg::Int32>("pressed", 5, std::bind(&Buttons::onPressed, this, std::placeholders::_1));
  }

private:
  void onPressed(const std_msgs::msg::Int32 & floor)
  {
    if (floor.data >= 0) {
      call_pub_->publish(floor);
    }
  }

  rclcpp::Publisher<std_msgs::msg::Int32>::SharedPtr call_pub_;
  rclcpp::Subscription<std_msgs::msg::Int32>::SharedPtr pressed_sub_;
};

class Display : public rclcpp::Node
{
public:
  Display() : Node("display")
  {
    text_pub_ = create_publisher<std_msgs::msg::String>("~/text", 1);
    floor_sub_ = create_subscription<std_msgs::msg::Int32>("floor", 1, [this](std_msgs::msg::Int32::ConstSharedPtr floor) {
      std_msgs::msg::String text;
      text.data = std::to_string(floor->data);
      text_pub_->publish(text);
    });
  }

private:
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr text_pub_;
  rclcpp::Subscription<std_msgs::msg::Int32>::SharedPtr floor_sub_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto buttons = std::make_shared<Buttons>();
  auto display = std::make_shared<Display>();
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(buttons);
  executor.add_node(display);
  executor.spin();
  rclcpp::shutdown();
  return 0;
}
