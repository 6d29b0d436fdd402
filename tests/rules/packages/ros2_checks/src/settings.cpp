// Parameters of ROS 2 have one type.
// expect: 10 = count : { parameter_access_default(_, _, _) }, 15 = count : { parameter_access_type(_, _, _) }
// expect: 1 = count : { parameter_of_any_type(_) }, 6 = count : { value_source(_, _) }
#include <rclcpp/rclcpp.hpp>

class Settings : public rclcpp::Node {
public:
  Settings() : Node("settings") {
    declare_parameter("rate", 10.0);
    declare_parameter<int>("size", 5);
    declare_parameter<std::vector<double>>("gains", {1.0, 2.0});
    declare_parameter("name", std::string("settings"));
    declare_parameter("frame", "base");
    declare_parameter<bool>("verbose");
    declare_parameter("limit", rclcpp::PARAMETER_DOUBLE);  // expect: param limit type=double op=declare
    declare_parameter("any", rclcpp::ParameterValue(1));
    declare_parameter<std::string>("map");  // expect: finding parameter-required "/settings declares the parameter /settings/map without a default, but nothing sets it"
    declare_parameter("model", rclcpp::PARAMETER_STRING);  // expect: finding parameter-required "*/settings/model*"
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.dynamic_typing = true;
    declare_parameter("dynamic", 1, descriptor);
    double step = declare_parameter("step", 1.0);
    size_ = get_parameter("size").as_int();
    get_parameter("rate", rate_);
    get_parameter_or("other", other_, 5.0);
    model_ = get_parameter("model").as_string();
    declare_parameter("prefix", rclcpp::PARAMETER_STRING);  // expect-not: finding parameter-required
    has_prefix_ = get_parameter("prefix", prefix_);
  }
  int size_;
  double rate_, other_;
  std::string model_, prefix_;
  bool has_prefix_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Settings>());
}
