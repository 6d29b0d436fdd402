// What decides whether a goal is taken decides what is done for it, and what its client gets back; so does what its result is made of.
//
// expect: port_flow([_, _, "lock"], [_, "publisher", "moves"], "control", _)
// expect: port_flow([_, _, "lock"], [_, "action_server", "lift"], "control", "kept")
// expect: port_flow([_, _, "weight"], [_, "action_server", "lift"], "data", "kept")
// expect-not: port_flow([_, _, "weight"], [_, "publisher", "moves"], _, _)
#include <example_interfaces/action/fibonacci.hpp>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_action/rclcpp_action.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_msgs/msg/int32.hpp>
#include <thread>

class Crane : public rclcpp::Node
{
public:
  using Lift = example_interfaces::action::Fibonacci;
  using Handle = rclcpp_action::ServerGoalHandle<Lift>;

  Crane() : Node("crane")
  {
    moves_ = create_publisher<std_msgs::msg::Bool>("moves", 1);
    lock_ = create_subscription<std_msgs::msg::Bool>("lock", 1, [this](const std_msgs::msg::Bool & msg) { locked_ = msg.data; });
    weight_ = create_subscription<std_msgs::msg::Int32>("weight", 1, [this](const std_msgs::msg::Int32 & msg) { heavy_ = msg.data; });
    server_ = rclcpp_action::create_server<Lift>(
      this, "lift",
      [this](const rclcpp_action::GoalUUID &, std::shared_ptr<const Lift::Goal>) {
        return locked_ ? rclcpp_action::GoalResponse::REJECT : rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
      },
      [](std::shared_ptr<Handle>) { return rclcpp_action::CancelResponse::ACCEPT; },
      [this](std::shared_ptr<Handle> handle) { std::thread([this, handle] { lift(handle); }).detach(); });
  }

private:
  void lift(std::shared_ptr<Handle> handle)
  {
    moves_->publish(std_msgs::msg::Bool());
    auto result = std::make_shared<Lift::Result>();
    result->sequence.push_back(heavy_);
    handle->succeed(result);
  }

  bool locked_ = false;
  int heavy_ = 0;
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr moves_;
  rclcpp::Subscription<std_msgs::msg::Bool>::SharedPtr lock_;
  rclcpp::Subscription<std_msgs::msg::Int32>::SharedPtr weight_;
  rclcpp_action::Server<Lift>::SharedPtr server_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Crane>());
}
