// Texts that messages define.
//
// expect: param bond_disable_heartbeat_timeout = true op=declare
// expect-only: param * op=declare
// expect-not: cannot_be(_, _, _, _)
#include <bond/msg/constants.hpp>
#include <rclcpp/rclcpp.hpp>

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("robot");
  node->declare_parameter(bond::msg::Constants::DISABLE_HEARTBEAT_TIMEOUT_PARAM, true);
  rclcpp::spin(node);
}
