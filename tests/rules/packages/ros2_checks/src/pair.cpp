// A program of two nodes, which the launch file does not name: what it sets is set for both.
// expect-not: finding parameter-required "*/side*"
// expect-not: finding parameter-in-other-namespace
// expect: 1 = count : { single_threaded(_) }
#include <rclcpp/rclcpp.hpp>

class Left : public rclcpp::Node {
public:
  Left() : Node("left") { declare_parameter<std::string>("side"); }
};

class Right : public rclcpp::Node {
public:
  Right() : Node("right") {
    declare_parameter<std::string>("side");
    declare_parameter<double>("force");  // expect: finding parameter-required "/right declares the parameter /right/force*"
  }
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  auto left = std::make_shared<Left>();
  auto right = std::make_shared<Right>();
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(left);
  executor.add_node(right);
  executor.spin();
}
