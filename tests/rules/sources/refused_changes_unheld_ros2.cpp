// A callback of parameters that nothing holds: it is gone before the parameter is declared.
//
// expect: 0 = count : { refuses_number(_, _, _, _, _) }
#include <memory>
#include <vector>
#include <rclcpp/rclcpp.hpp>

class Knob : public rclcpp::Node {
public:
  Knob() : Node("knob") {
    add_on_set_parameters_callback([](const std::vector<rclcpp::Parameter>& parameters) {
      rcl_interfaces::msg::SetParametersResult result;
      result.successful = true;
      for (const auto& p : parameters) {
        if (p.get_name() == "rate" && p.as_double() > 10.0) {
          result.successful = false;
        }
      }
      return result;
    });
    declare_parameter("rate", 2.0);
  }
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Knob>());
}
