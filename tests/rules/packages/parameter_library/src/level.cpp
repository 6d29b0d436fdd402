// Parameters that generate_parameter_library makes of a YAML file.
//
// expect: param rate = 4.0
// expect: param topic = level
// expect: param alarm.limit
// expect: param alarm.pumps = "[left, right]"
// expect: param gains.left.p = 0.5
// expect: param gains.right.p = 0.5
// expect: parameter_access(C, "declare", "rate"), node_location(C, Path, 3, 3), contains("level.yaml", Path)
// expect: publisher level std_msgs/Float64
// expect: port_parameter([_, _, "level"], "topic")
// expect: periodic level 4 Hz
#include <chrono>
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/float64.hpp>
#include <tank_level/level_parameters.hpp>

class Level : public rclcpp::Node
{
public:
  Level() : Node("level"), listener_(std::make_shared<tank_level::ParamListener>(get_node_parameters_interface()))
  {
    params_ = listener_->get_params();
    publisher_ = create_publisher<std_msgs::msg::Float64>(params_.topic, 1);
    timer_ = create_wall_timer(std::chrono::duration<double>(1.0 / params_.rate), [this]() {publisher_->publish(std_msgs::msg::Float64());});
  }

private:
  std::shared_ptr<tank_level::ParamListener> listener_;
  tank_level::Params params_;
  rclcpp::Publisher<std_msgs::msg::Float64>::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Level>());
}
