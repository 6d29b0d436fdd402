// Parameters that are read into what nothing uses.
//
// expect: parameter_value_unused(_, "limit")
// expect: parameter_value_unused(_, "name")
// expect: 2 = count : { parameter_value_unused(_, Name) }
#include <memory>
#include <string>
#include <rclcpp/rclcpp.hpp>

struct Settings {
  double width;
};

class Drive : public rclcpp::Node {
public:
  Drive() : Node("drive") {
    limit_ = declare_parameter("limit", 2.0);
    declare_parameter("name", "drive");
    get_parameter("name", name_);
    settings_.width = declare_parameter("width", 1.0);
    gain_ = declare_parameter("gain", 1.0);
    RCLCPP_INFO(get_logger(), "%f", gain_);
  }

private:
  double limit_, gain_;
  std::string name_;
  Settings settings_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Drive>());
}
