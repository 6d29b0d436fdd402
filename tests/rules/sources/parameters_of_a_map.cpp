// Parameters that a map declares, each below a common name, and that are read together.
//
// expect: param wheels.left = 3 op=declare
// expect: param wheels.right = -1 op=declare
// expect: param speed = 0.5 op=declare
// expect-only: param * op=declare
// expect: param wheels.left = 3 op=read
// expect: param wheels.right = -1 op=read
// expect-only: param * op=read
#include <map>
#include <rclcpp/rclcpp.hpp>
#include <string>

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("robot");
  std::map<std::string, int64_t> wheels{
    {"left", 3L},
    {"right", -1L},
  };
  node->declare_parameters("wheels", wheels);
  node->declare_parameters<double>("", {{"speed", 0.5}});
  std::map<std::string, int64_t> found;
  node->get_parameters("wheels", found);
  rclcpp::spin(node);
}
