// Functions that run when the program is told to end.
//
// expect: activity(F, "signal"), function_name(F, "Robot::stop")
// expect: transition Robot::running_ = false
// expect: 3 = count : { activity(_, "signal") }
#include <functional>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>

class Robot : public rclcpp::Node
{
public:
  Robot() : Node("robot")
  {
    state_ = create_publisher<std_msgs::msg::Bool>("state", 1);
    timer_ = create_wall_timer(std::chrono::seconds(1), [this]() {
      if (running_)
        state_->publish(std_msgs::msg::Bool());
    });
    auto context = get_node_base_interface()->get_context();
    context->add_pre_shutdown_callback(std::bind(&Robot::stop, this));
    context->add_on_shutdown_callback([this]() { timer_.reset(); });
    rclcpp::on_shutdown([this]() { state_.reset(); });
  }

private:
  void stop()
  {
    running_ = false;
  }

  bool running_ = true;
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr state_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
}
