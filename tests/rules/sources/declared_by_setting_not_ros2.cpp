// Parameters that the options of a node do not declare.
//
// expect-not: declared_by_setting(_, _)
#include <memory>
#include <rclcpp/rclcpp.hpp>

class Gain : public rclcpp::Node {
public:
  Gain() : Node("gain", rclcpp::NodeOptions().automatically_declare_parameters_from_overrides(false)) {
    declare_parameter("gain", 1.0);
    if (!has_parameter("offset")) declare_parameter("offset", 0.0);
    declare_parameter("fixed", 0.0, rcl_interfaces::msg::ParameterDescriptor(), true);
    try {
      declare_parameter("tried", 0.0);
    } catch (const rclcpp::exceptions::ParameterAlreadyDeclaredException&) {
    }
  }
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Gain>());
}
