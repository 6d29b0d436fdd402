// expect-not: finding library-* "/good1*"
// expect-not: finding after-spin "/good1*"
// expect-not: finding period-of-zero "/good1*"
// expect: component good1 package=beginnings
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
class A : public rclcpp::Node
{
public:
  A() : Node("good1")
  {
    double rate = 20;
    timer_ = create_wall_timer(std::chrono::duration<double>(1 / rate), [this]() {RCLCPP_INFO(get_logger(), "x");});
  }
  rclcpp::TimerBase::SharedPtr timer_;
};
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<A>();
  rclcpp::spin(node);
  rclcpp::shutdown();
}
