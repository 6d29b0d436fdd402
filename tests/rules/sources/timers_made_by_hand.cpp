// Timers of ROS 2 that are made without a node and added to it.
//
// expect: periodic beat hz=4 mechanism=timer
// expect: periodic slow hz=0.5 mechanism=timer
#include <chrono>
#include <functional>
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/empty.hpp>

using namespace std::chrono_literals;

class Clocks : public rclcpp::Node
{
public:
  Clocks() : Node("clocks")
  {
    beat_ = create_publisher<std_msgs::msg::Empty>("beat", 1);
    slow_ = create_publisher<std_msgs::msg::Empty>("slow", 1);
    timer_ = rclcpp::GenericTimer<rclcpp::VoidCallbackType>::make_shared(
      get_clock(), std::chrono::nanoseconds(250ms), std::bind(&Clocks::beat, this), get_node_base_interface()->get_context());
    get_node_timers_interface()->add_timer(timer_, nullptr);
    std::function<void()> callback = [this]() { slow_->publish(std_msgs::msg::Empty()); };
    wall_timer_ = std::make_shared<rclcpp::WallTimer<std::function<void()>>>(2s, callback, get_node_base_interface()->get_context());
    get_node_timers_interface()->add_timer(wall_timer_, nullptr);
  }

private:
  void beat()
  {
    beat_->publish(std_msgs::msg::Empty());
  }

  rclcpp::Publisher<std_msgs::msg::Empty>::SharedPtr beat_, slow_;
  rclcpp::TimerBase::SharedPtr timer_, wall_timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Clocks>());
}
