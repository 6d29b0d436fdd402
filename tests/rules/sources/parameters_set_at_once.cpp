// Parameters that are set, or asked for, several at once.
//
// expect: param speed = 1.0 op=declare
// expect: param frame = base op=declare
// expect: param speed = 2.0 op=write
// expect: param frame = map op=write
// expect: param limit = 3 op=write
// expect: param speed op=read
// expect: param frame op=read
// expect: param limit op=read
// expect-only: param
#include <rclcpp/rclcpp.hpp>

class Arm : public rclcpp::Node {
public:
  Arm() : rclcpp::Node("arm") {
    declare_parameter("speed", 1.0);
    declare_parameter("frame", "base");
    set_parameters({rclcpp::Parameter("speed", 2.0), rclcpp::Parameter("frame", "map")});
    get_node_parameters_interface()->set_parameters_atomically({rclcpp::Parameter("limit", 3)});
    const auto both = get_parameters({"speed", "frame"});
    const std::vector<std::string> names{"limit"};
    for (const auto & value : get_parameters(names)) RCLCPP_INFO(get_logger(), "%s", value.get_name().c_str());
  }
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Arm>());
}
