// Messages whose headers come in by way of headers that are absent: their names tell what they are, wherever `using` brings them.
//
// expect: publisher one far_msgs/One
// expect: publisher two far_msgs/Two
// expect: publisher three far_msgs/Three
// expect: subscriber four far_msgs/Four
// expect: service_server ~five far_msgs/Five
// expect: reactive four -> one
#include <far/everything.hpp>
#include <rclcpp/rclcpp.hpp>

using far_msgs::msg::One;
namespace brought
{
using far_msgs::msg::Two;
using Three = far_msgs::msg::Three;
}

class Talker : public rclcpp::Node
{
public:
  Talker() : Node("talker")
  {
    one_ = create_publisher<One>("one", 1);
    two_ = create_publisher<brought::Two>("two", 1);
    three_ = create_publisher<brought::Three>("three", 1);
    four_ = create_subscription<far_msgs::msg::Four>("four", 1, [this](const far_msgs::msg::Four::ConstSharedPtr four) {
      if (four->value > 3) {
        one_->publish(One());
      }
    });
    five_ = create_service<far_msgs::srv::Five>(
      "~/five", [](const far_msgs::srv::Five::Request::SharedPtr, far_msgs::srv::Five::Response::SharedPtr) {});
  }

private:
  rclcpp::Publisher<One>::SharedPtr one_;
  rclcpp::Publisher<brought::Two>::SharedPtr two_;
  rclcpp::Publisher<brought::Three>::SharedPtr three_;
  rclcpp::Subscription<far_msgs::msg::Four>::SharedPtr four_;
  rclcpp::Service<far_msgs::srv::Five>::SharedPtr five_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Talker>());
}
