// How often a loop waits for a rate whose class derives from one of the library, and whose constructor takes other arguments as well.
//
// expect: periodic odom 20 Hz mechanism=rate
// expect: periodic pose 5 Hz mechanism=rate
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/empty.hpp>

class Pace : public rclcpp::Rate
{
public:
  template <typename NodeT>
  explicit Pace(NodeT node, double rate) : rclcpp::Rate(rate, node->get_clock())
  {
  }
};

class Slow : public rclcpp::Rate
{
public:
  Slow() : rclcpp::Rate(5)
  {
  }
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("pacer");
  auto odom = node->create_publisher<std_msgs::msg::Empty>("odom", 1);
  auto pose = node->create_publisher<std_msgs::msg::Empty>("pose", 1);
  if (argc > 1) {
    Pace pace(node, node->declare_parameter("rate", 20.0));
    while (rclcpp::ok()) {
      odom->publish(std_msgs::msg::Empty());
      pace.sleep();
    }
  }
  Slow slow;
  while (rclcpp::ok()) {
    pose->publish(std_msgs::msg::Empty());
    slow.sleep();
  }
}
