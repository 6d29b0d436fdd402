// A node by an absent base class: what its methods make with a message are ports, called with and without `this`.
//
// expect: publisher answer std_msgs/Int32 queue=1
// expect: subscriber number std_msgs/Int32 queue=1 callback=Base::onNumber
// expect: subscriber limit std_msgs/Int32 queue=1 callback=Base::onNumber
// expect-only: publisher subscriber
// expect: open_at("ports", _, ["call", "create_subscription"])
#include <absent_base/base.hpp>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/int32.hpp>

class Base : public absent_base::Base
{
public:
  Base() : absent_base::Base("base")
  {
    answer_ = create_publisher<std_msgs::msg::Int32>("answer", 1);
    number_ = create_subscription<std_msgs::msg::Int32>("number", 1, std::bind(&Base::onNumber, this, std::placeholders::_1));
    limit_ = this->create_subscription<std_msgs::msg::Int32>("limit", 1, std::bind(&Base::onNumber, this, std::placeholders::_1));
    untold_ = this->create_subscription("untold", 1, std::bind(&Base::onNumber, this, std::placeholders::_1));
  }

private:
  void onNumber(std_msgs::msg::Int32::ConstSharedPtr) {}

  rclcpp::Publisher<std_msgs::msg::Int32>::SharedPtr answer_;
  rclcpp::Subscription<std_msgs::msg::Int32>::SharedPtr number_, limit_, untold_;
};

int main(int argc, char** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Base>());
}
