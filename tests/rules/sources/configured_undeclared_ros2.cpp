// A member is given the value of a parameter that its node declares; one that nothing declares has the value that the code tells, whatever is set.
//
// expect: keeps_value_of("loud_", "loud")
// expect: N = count : { keeps_value_of(_, _) }, N = 1
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/empty.hpp>

class Relay : public rclcpp::Node {
public:
  Relay() : Node("relay") {
    loud_ = declare_parameter("loud", true);
    get_parameter_or("active", active_, true);
    out_ = create_publisher<std_msgs::msg::Empty>("out", 1);
    in_ = create_subscription<std_msgs::msg::Empty>("in", 1, [this](const std_msgs::msg::Empty& m) {
      if (active_ && loud_) out_->publish(m);
    });
  }

private:
  bool loud_, active_;
  rclcpp::Publisher<std_msgs::msg::Empty>::SharedPtr out_;
  rclcpp::Subscription<std_msgs::msg::Empty>::SharedPtr in_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Relay>());
}
