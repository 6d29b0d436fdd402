// Values that a callback of parameters refuses before they are declared.
//
// expect: refuses_number(_, "rate", "value", ">", "10.0")
// expect: 1 = count : { refuses_number(_, _, _, _, _) }
#include <memory>
#include <vector>
#include <rclcpp/rclcpp.hpp>

class Knob : public rclcpp::Node {
public:
  Knob() : Node("knob") {
    check_ = add_on_set_parameters_callback([](const std::vector<rclcpp::Parameter>& parameters) {
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

private:
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr check_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Knob>());
}
