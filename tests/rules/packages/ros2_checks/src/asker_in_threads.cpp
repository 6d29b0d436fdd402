// Callbacks that wait for answers while several threads run callbacks: only those in the group of the client keep the answer out.
// expect-not: finding callback-deadlock "*/reentrant,*"
// expect: 3 = count : { callback_in_group(_, _, _) }, 1 = count : { numeric(_) }
// expect-not: single_threaded(_)
#include <chrono>
#include <rclcpp/rclcpp.hpp>
#include <std_srvs/srv/trigger.hpp>

using Trigger = std_srvs::srv::Trigger;
using namespace std::chrono_literals;

class AskerInThreads : public rclcpp::Node {
public:
  AskerInThreads() : Node("asker_in_threads") {
    group_ = create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
    any_ = create_callback_group(rclcpp::CallbackGroupType::Reentrant);
    grouped_ = create_client<Trigger>("grouped", rclcpp::ServicesQoS(), group_);
    reentrant_ = create_client<Trigger>("reentrant", rclcpp::ServicesQoS(), any_);
    timer_ = create_wall_timer(1s, std::bind(&AskerInThreads::onTimer, this), group_);
    server_ = create_service<Trigger>("serve", [this](Trigger::Request::SharedPtr, Trigger::Response::SharedPtr) {
      reentrant_->async_send_request(std::make_shared<Trigger::Request>()).get();
    });
    on_set_ = add_on_set_parameters_callback([this](const std::vector<rclcpp::Parameter> &) {
      reentrant_->async_send_request(std::make_shared<Trigger::Request>()).get();
      return rcl_interfaces::msg::SetParametersResult();
    });
  }

private:
  void onTimer() {
    reentrant_->async_send_request(std::make_shared<Trigger::Request>()).get();
    auto answer = grouped_->async_send_request(std::make_shared<Trigger::Request>());
    answer.wait();  // expect: finding callback-deadlock "*/asker_in_threads*/grouped,*one callback group*"
    answer.get();   // expect-not: finding callback-deadlock
  }
  rclcpp::CallbackGroup::SharedPtr group_, any_;
  rclcpp::Client<Trigger>::SharedPtr grouped_, reentrant_;
  rclcpp::Service<Trigger>::SharedPtr server_;
  rclcpp::TimerBase::SharedPtr timer_;
  OnSetParametersCallbackHandle::SharedPtr on_set_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<AskerInThreads>();
  rclcpp::executors::MultiThreadedExecutor executor;
  executor.add_node(node);
  executor.spin();
}
