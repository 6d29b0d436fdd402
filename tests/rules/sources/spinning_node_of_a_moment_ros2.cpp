// A node that only the call which gives it to an executor holds, and ones that something keeps.
//
// expect: 1 = count : { runs_too_little(_, "dropped") }
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

std::shared_ptr<Lamp> kept;

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto first = std::make_shared<Lamp>();
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(first);
  executor.add_node(kept = std::make_shared<Lamp>());
  executor.add_node(std::make_shared<Lamp>());
  executor.spin();
}
