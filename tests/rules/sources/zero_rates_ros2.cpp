// Rates of parameters that may not be zero, in a program that loops.
//
// expect: refuses_number(_, "rate", "value", "<=", "0")
// expect: refuses_number(_, "hz", "value", "==", "0")
// expect: period_of_parameter(_, "period")
// expect: 2 = count : { refuses_number(_, _, _, _, _) }
#include <chrono>
#include <memory>
#include "rclcpp/rclcpp.hpp"

class Pulse : public rclcpp::Node
{
public:
  Pulse() : Node("pulse")
  {
    declare_parameter("hz", 10.0);
    get_parameter("hz", hz_);
    timer_ = create_wall_timer(std::chrono::duration<double>(1.0 / hz_), [this]() { tick(); });
    const int period = declare_parameter("period", 100);
    slow_ = create_wall_timer(std::chrono::milliseconds(period), [this]() { tick(); });
  }

private:
  void tick() {}
  double hz_{10.0};
  rclcpp::TimerBase::SharedPtr timer_;
  rclcpp::TimerBase::SharedPtr slow_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Pulse>();
  const double rate = node->declare_parameter("rate", 10.0);
  rclcpp::Rate loop(rate);
  while (rclcpp::ok()) {
    rclcpp::spin_some(node);
    loop.sleep();
  }
  rclcpp::shutdown();
}
