// Parameters whose default is a list. The text of a list that is a container's, and of one that only stands for a text.
#include <memory>
#include <string>
#include <vector>

#include <rclcpp/rclcpp.hpp>

class Arm : public rclcpp::Node {
 public:
  Arm() : Node("arm") {
    declare_parameter("gains", std::vector<double>{0.5, -1.0});                           // expect: param gains = "[0.5, -1.0]"
    declare_parameter("limits", rclcpp::ParameterValue(std::vector<int>{1, 2}));          // expect: param limits = "[1, 2]"
    declare_parameter("nothing", std::vector<std::string>());                             // expect: param nothing = "[]"
    declare_parameter("empty", std::vector<std::string>{});                               // expect: param empty = "[]"
    declare_parameter("frame", std::string{"base"});                                      // expect: param frame = base
  }
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Arm>());
}
