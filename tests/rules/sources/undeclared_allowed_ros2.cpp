// A node that declares whatever it is given.
//
// expect-not: undeclared_read(_, _, _)
// expect: parameter_access(_, "read", "rate")
#include <rclcpp/rclcpp.hpp>

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("driver", rclcpp::NodeOptions().automatically_declare_parameters_from_overrides(true));
  double rate;
  node->get_parameter("rate", rate);
  rclcpp::spin(node);
}
