// What comes back to requests and goals is handed to callbacks of their clients.
// expect-only: reactive * -> *
// expect-only: transition *
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_action/rclcpp_action.hpp>
#include <nav2_msgs/action/navigate_to_pose.hpp>
#include <std_msgs/msg/string.hpp>
#include <std_srvs/srv/trigger.hpp>

using Drive = nav2_msgs::action::NavigateToPose;
using Text = std_msgs::msg::String;
using Trigger = std_srvs::srv::Trigger;

class Courier : public rclcpp::Node {
public:
  Courier() : Node("courier") {
    drive_ = rclcpp_action::create_client<Drive>(this, "drive");
    open_ = create_client<Trigger>("open");
    told_ = create_publisher<Text>("told", 1);
    order_ = create_subscription<Text>("order", 1, [this](const Text &) { send(); });
  }

private:
  void send() {
    if (busy_) return;
    auto options = rclcpp_action::Client<Drive>::SendGoalOptions();
    options.result_callback = std::bind(&Courier::arrived, this, std::placeholders::_1);
    options.feedback_callback = nullptr;
    goal_ = drive_->async_send_goal(Drive::Goal(), options);
    // expect: reactive order -> drive may
    busy_ = true;  // expect: transition busy_ = true on order
  }

  void arrived(const rclcpp_action::ClientGoalHandle<Drive>::WrappedResult &) {
    busy_ = false;  // expect: transition busy_ = false on drive
    open_->async_send_request(std::make_shared<Trigger::Request>(), [this](rclcpp::Client<Trigger>::SharedFuture) {
      told_->publish(Text());
    });
    // expect: reactive drive -> open must
    // expect: reactive open -> told must
  }

  bool busy_ = false;
  std::shared_future<rclcpp_action::ClientGoalHandle<Drive>::SharedPtr> goal_;
  rclcpp_action::Client<Drive>::SharedPtr drive_;
  rclcpp::Client<Trigger>::SharedPtr open_;
  rclcpp::Publisher<Text>::SharedPtr told_;
  rclcpp::Subscription<Text>::SharedPtr order_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Courier>());
}
