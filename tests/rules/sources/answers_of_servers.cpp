// What comes back to requests and goals is handed to callbacks of their clients.
// expect-only: reactive * -> *
// expect-only: transition *
// expect: N = count : { default_group(_, _) }, N = 3, 2 = count : { asks(_, _, _) }, 2 = count : { future_of(_, _) }
// expect-not: callback_group(_, _); _group_set(_, _); _another_group(_); exclusive_group(_); _group_made(_, _); _made_otherwise(_); _exclusive(_)
// expect-not: _keeps_future(_, _); _waits(_, _); _wait_time(_, _); _polled(_); awaits_answer(_, _); _leads_to_wait(_, _); callback_in_group(_, _, _)
// expect-not: _handed_by(_, _); _kept_in_group(_); _called_for_parameters(_, _); answer_kept_out(_, _, _); _waits_for_answer(_, _)
// expect-not: _waits_earlier(_, _, _, _); _answer_for(_, _, _); _kept_out(_, _); _in_one_thread(_, _); _runs_callbacks(_); _served_apart(_)
// expect-not: _group_call(_); executor_of_threads(_)
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
