#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
class A : public rclcpp::Node
{
public:
  A() : Node("bad2")
  {
    int rate = 20;
    timer_ = create_wall_timer(std::chrono::seconds(1 / rate), [this]() {RCLCPP_INFO(get_logger(), "x");});  // expect: finding period-of-zero "/bad2 makes a timer whose period is zero*"
  }
  rclcpp::TimerBase::SharedPtr timer_;
};
int main(int argc, char ** argv)
{
  auto node = std::make_shared<A>();  // expect: finding library-not-started "/bad2 uses rclcpp, which nothing in its program initialises"
  rclcpp::spin(node);
  rclcpp::shutdown();
}
