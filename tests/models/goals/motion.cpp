// The same of ROS 2: what decides on a goal and what begins it run for one request, what decides on a wish to end it for another.
#include <example_interfaces/action/fibonacci.hpp>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_action/rclcpp_action.hpp>
#include <std_msgs/msg/float32.hpp>

using Fibonacci = example_interfaces::action::Fibonacci;
using Handle = rclcpp_action::ServerGoalHandle<Fibonacci>;

enum State { IDLE, WANTED, MOVING };

class Motion : public rclcpp::Node {
public:
  Motion() : Node("motion") {
    server_ = rclcpp_action::create_server<Fibonacci>(
      this, "move",
      [this](const rclcpp_action::GoalUUID&, std::shared_ptr<const Fibonacci::Goal>) {
        state_ = WANTED;
        return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
      },
      [this](const std::shared_ptr<Handle>) {
        state_ = IDLE;
        return rclcpp_action::CancelResponse::ACCEPT;
      },
      [this](const std::shared_ptr<Handle>) { state_ = MOVING; });
    velocity_ = create_publisher<std_msgs::msg::Float32>("velocity", 1);
    timer_ = create_wall_timer(std::chrono::seconds(1), [this] {
      if (state_ == MOVING) velocity_->publish(std_msgs::msg::Float32());
    });
  }

private:
  State state_ = IDLE;
  rclcpp_action::Server<Fibonacci>::SharedPtr server_;
  rclcpp::Publisher<std_msgs::msg::Float32>::SharedPtr velocity_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Motion>());
}
