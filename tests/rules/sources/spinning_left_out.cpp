// A node that is made and not spun, one without callbacks, and one that is.
//
// expect: 1 = count : { runs_too_little(_, "left_out") }
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>

class Lamp : public rclcpp::Node {
public:
  Lamp() : Node("lamp") {
    sub_ = create_subscription<std_msgs::msg::Bool>("on", 10, [](std_msgs::msg::Bool::ConstSharedPtr) {});
  }

private:
  rclcpp::Subscription<std_msgs::msg::Bool>::SharedPtr sub_;
};

class Quiet : public rclcpp::Node {
public:
  Quiet() : Node("quiet") {}
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto first = std::make_shared<Lamp>();
  auto second = std::make_shared<Lamp>();
  auto quiet = std::make_shared<Quiet>();
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(first);
  executor.spin();
}
