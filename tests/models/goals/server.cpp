// `work` may reject goals, `play` accepts each.
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_action/rclcpp_action.hpp>
#include <example_interfaces/action/fibonacci.hpp>

using Fibonacci = example_interfaces::action::Fibonacci;
using Handle = rclcpp_action::ServerGoalHandle<Fibonacci>;

class Server : public rclcpp::Node {
public:
  Server() : Node("server") {
    work_ = rclcpp_action::create_server<Fibonacci>(
      this, "work",
      [this](const rclcpp_action::GoalUUID&, std::shared_ptr<const Fibonacci::Goal> goal) {
        return goal->order > 0 ? rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE : rclcpp_action::GoalResponse::REJECT;
      },
      [this](const std::shared_ptr<Handle>) { return rclcpp_action::CancelResponse::REJECT; },
      [this](const std::shared_ptr<Handle> handle) { handle->succeed(std::make_shared<Fibonacci::Result>()); });
    play_ = rclcpp_action::create_server<Fibonacci>(
      this, "play",
      [this](const rclcpp_action::GoalUUID&, std::shared_ptr<const Fibonacci::Goal>) {
        return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
      },
      [this](const std::shared_ptr<Handle>) { return rclcpp_action::CancelResponse::REJECT; },
      [this](const std::shared_ptr<Handle> handle) { handle->succeed(std::make_shared<Fibonacci::Result>()); });
  }

private:
  rclcpp_action::Server<Fibonacci>::SharedPtr work_, play_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Server>());
}
