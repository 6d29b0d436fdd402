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
    joints_ = declare_parameter("joints", joints_);                                       // expect: param joints = "[left, right]"
    covariance_ = declare_parameter<std::vector<double>>("covariance", covariance_);      // expect: param covariance = "[0.1, 0.2, 0.3]"
    many_.push_back(4.0);
    many_ = declare_parameter("many", many_);                                             // expect-not: param many = 4.0
  }

 private:
  std::vector<std::string> joints_ = {"left", "right"};
  std::vector<double> covariance_{0.1, 0.2, 0.3};
  std::vector<double> many_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Arm>());
}
