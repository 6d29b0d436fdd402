// What becomes of a goal of rclcpp_action: the options come from a function, the result and the cancelling are asked for.
//
// expect: 4 = count : { answer_callback(C, F) }
// expect-only: reactive * -> *
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_action/rclcpp_action.hpp>
#include <std_msgs/msg/empty.hpp>
#include <example_interfaces/action/fibonacci.hpp>
using Fibonacci = example_interfaces::action::Fibonacci;
using Client = rclcpp_action::Client<Fibonacci>;
using Handle = rclcpp_action::ClientGoalHandle<Fibonacci>;

class Asker : public rclcpp::Node {
 public:
  Asker() : Node("asker") {
    client_ = rclcpp_action::create_client<Fibonacci>(this, "dock");
    begun_ = create_publisher<std_msgs::msg::Empty>("begun", 1);
    moves_ = create_publisher<std_msgs::msg::Empty>("moves", 1);
    done_ = create_publisher<std_msgs::msg::Empty>("done", 1);
    stopped_ = create_publisher<std_msgs::msg::Empty>("stopped", 1);
    order_ = create_subscription<std_msgs::msg::Empty>("order", 1, [this](const std_msgs::msg::Empty&) { send(); });
    halt_ = create_subscription<std_msgs::msg::Empty>("halt", 1, [this](const std_msgs::msg::Empty&) { halt(); });
  }

 private:
  Client::SendGoalOptions options() {
    Client::SendGoalOptions made;
    made.goal_response_callback = [this](Handle::SharedPtr handle) { onHandle(handle); };
    watch(made);
    return made;
  }
  void watch(Client::SendGoalOptions& given) {
    given.feedback_callback = [this](Handle::SharedPtr, const std::shared_ptr<const Fibonacci::Feedback>) {
      moves_->publish(std_msgs::msg::Empty());  // expect: reactive dock -> moves must
    };
  }
  void send() {
    client_->async_send_goal(Fibonacci::Goal(), options());  // expect: reactive order -> dock must
  }
  void onHandle(Handle::SharedPtr handle) {
    handle_ = handle;
    begun_->publish(std_msgs::msg::Empty());  // expect: reactive dock -> begun must
    client_->async_get_result(handle, [this](const Handle::WrappedResult&) {
      done_->publish(std_msgs::msg::Empty());  // expect: reactive dock -> done must
    });
  }
  void halt() {
    client_->async_cancel_goal(handle_, [this](Client::CancelResponse::SharedPtr) {
      stopped_->publish(std_msgs::msg::Empty());  // expect: reactive dock -> stopped must
    });
  }

  Client::SharedPtr client_;
  Handle::SharedPtr handle_;
  rclcpp::Publisher<std_msgs::msg::Empty>::SharedPtr begun_, moves_, done_, stopped_;
  rclcpp::Subscription<std_msgs::msg::Empty>::SharedPtr order_, halt_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Asker>());
  return 0;
}
