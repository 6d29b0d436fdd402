// A timer that is made anew, with another period, when a parameter is set: how often it runs is not known.
//
// expect: sent_untimed([_, _, "out"])
// expect: 1 = count : { sent_untimed(_) }
// expect: unsteady(_, "something is done with it later")
#include <chrono>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/empty.hpp>

class Ticker : public rclcpp::Node {
public:
  Ticker() : Node("ticker") {
    out_ = create_publisher<std_msgs::msg::Empty>("out", 1);
    plain_ = create_publisher<std_msgs::msg::Empty>("plain", 1);
    begin(declare_parameter("rate", 10.0));
    other_ = create_wall_timer(std::chrono::seconds(1), [this]() { plain_->publish(std_msgs::msg::Empty()); });
    handle_ = add_on_set_parameters_callback([this](const std::vector<rclcpp::Parameter>& parameters) {
      for (const auto& parameter : parameters)
        if (parameter.get_name() == "rate") begin(parameter.as_double());
      rcl_interfaces::msg::SetParametersResult result;
      result.successful = true;
      return result;
    });
  }

private:
  void begin(double rate) {
    timer_ = create_wall_timer(std::chrono::duration<double>(1.0 / rate), [this]() { out_->publish(std_msgs::msg::Empty()); });
  }
  rclcpp::Publisher<std_msgs::msg::Empty>::SharedPtr out_, plain_;
  rclcpp::TimerBase::SharedPtr timer_, other_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr handle_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Ticker>());
}
