// Fields that do not begin with zero: the definition of a quaternion gives w a default.
// expect: content_begins(_, "z", _)
// expect-not: content_begins(_, "w", _)
// expect: content_given(_, "w", _, _)
#include <geometry_msgs/msg/quaternion.hpp>
#include <rclcpp/rclcpp.hpp>

class Turner : public rclcpp::Node
{
public:
  Turner() : Node("turner")
  {
    out_ = create_publisher<geometry_msgs::msg::Quaternion>("out", 1);
    in_ = create_subscription<geometry_msgs::msg::Quaternion>("in", 1, [this](const geometry_msgs::msg::Quaternion & in) {turn(in);});
  }

private:
  void turn(const geometry_msgs::msg::Quaternion & in)
  {
    geometry_msgs::msg::Quaternion message;
    if (in.x > 0) {
      message.z = 1;
      message.w = 0;
    }
    out_->publish(message);
  }

  rclcpp::Publisher<geometry_msgs::msg::Quaternion>::SharedPtr out_;
  rclcpp::Subscription<geometry_msgs::msg::Quaternion>::SharedPtr in_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Turner>());
  rclcpp::shutdown();
}
