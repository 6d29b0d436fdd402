// A callback may look at parameters that nothing else uses.
//
// expect: !parameter_value_unused(_, _)
#include <memory>
#include <vector>
#include <rclcpp/rclcpp.hpp>

class Drive : public rclcpp::Node {
public:
  Drive() : Node("drive") {
    limit_ = declare_parameter("limit", 2.0);
    handle_ = add_on_set_parameters_callback([](const std::vector<rclcpp::Parameter>&) {
      rcl_interfaces::msg::SetParametersResult result;
      result.successful = true;
      return result;
    });
  }

private:
  double limit_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr handle_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Drive>());
}
