// Rates of parameters that may not be zero, in a program that loops.
//
// expect: refuses_number(_, "rate", "value", "<=", "0")
// expect: refuses_number(_, "hz", "value", "==", "0")
// expect: period_of_parameter(_, "period")
// expect: period_of_parameter(_, "read")
// expect: 2 = count : { refuses_number(_, _, _, _, _) }
// expect: 2 = count : { period_of_parameter(_, _) }
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
    const int as_read = read("read");
    read_ = create_wall_timer(std::chrono::milliseconds(as_read), [this]() { tick(); });
    // these functions make sure that it is none
    const int least = at_least_one("least");
    least_ = create_wall_timer(std::chrono::milliseconds(least), [this]() { tick(); });
    int filled = 5;
    fill("filled", filled);
    filled_ = create_wall_timer(std::chrono::milliseconds(filled), [this]() { tick(); });
  }

private:
  int read(const std::string & name)
  {
    declare_parameter(name, 10);
    const int value = get_parameter(name).as_int();
    return value;
  }
  int at_least_one(const std::string & name)
  {
    const int value = declare_parameter(name, 10);
    return value < 1 ? 1 : value;
  }
  void fill(const std::string & name, int & value)
  {
    declare_parameter(name, 10);
    get_parameter(name, value);
    if (value < 1) {
      value = 1;
    }
  }
  void tick() {}
  double hz_{10.0};
  rclcpp::TimerBase::SharedPtr timer_;
  rclcpp::TimerBase::SharedPtr slow_;
  rclcpp::TimerBase::SharedPtr read_;
  rclcpp::TimerBase::SharedPtr least_;
  rclcpp::TimerBase::SharedPtr filled_;
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
