// Callbacks that wait for answers: in the group of the client, in another one, in a reentrant one, in one that is served apart. A single thread runs them.
// expect: N = count : { callback_group(_, _) }, N = 5, 4 = count : { default_group(_, _) }, 2 = count : { exclusive_group(_) }, 3 = count : { _group_made(_, _) }, 2 = count : { _exclusive(_) }, 9 = count : { _made_on(_, _) }, 1 = count : { _served_apart(_) }, 1 = count : { single_threaded(_) }
// expect: N = count : { asks(_, _, _) }, N = 6, 8 = count : { _waits(_, _) }, 2 = count : { _wait_time(_, _) }, 1 = count : { _polled(_) }, 5 = count : { awaits_answer(_, _) }, 5 = count : { _keeps_future(_, _) }, 3 = count : { answer_kept_out(_, _, _) }
// expect-not: finding callback-deadlock "*/separate,*"
// expect-not: finding callback-deadlock "*/polled,*"
// expect-not: finding callback-deadlock "*/later,*"
#include <chrono>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
#include <std_srvs/srv/trigger.hpp>

using Text = std_msgs::msg::String;
using Trigger = std_srvs::srv::Trigger;
using namespace std::chrono_literals;

class Asker : public rclcpp::Node {
public:
  Asker() : Node("asker") {
    group_ = create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
    any_ = create_callback_group(rclcpp::CallbackGroupType::Reentrant);
    apart_ = create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
    same_ = create_client<Trigger>("same");
    polled_ = create_client<Trigger>("polled");
    later_ = create_client<Trigger>("later");
    other_ = create_client<Trigger>("other", rclcpp::ServicesQoS(), group_);
    reentrant_ = create_client<Trigger>("reentrant", rclcpp::ServicesQoS(), any_);
    separate_ = create_client<Trigger>("separate", rclcpp::ServicesQoS(), apart_);
    rclcpp::SubscriptionOptions options;
    options.callback_group = group_;
    options.use_default_callbacks = false;
    rclcpp::SubscriptionOptions of_none;
    of_none.callback_group = any_;
    go_ = create_subscription<Text>("go", 10, [this](const Text & text) { onGo(text); });
    grouped_ = create_subscription<Text>("grouped_text", 10, std::bind(&Asker::onGrouped, this, std::placeholders::_1), options);
    timer_ = create_wall_timer(1s, [this]() { onTimer(); }, any_);
  }

private:
  bool ask() {
    auto result = same_->async_send_request(std::make_shared<Trigger::Request>());
    if (result.wait_for(1s) != std::future_status::ready) return false;  // expect: finding callback-deadlock "a callback of /asker waits for the response of /same, which cannot arrive before the callback ends: both belong to one callback group, which is not reentrant"
    return result.get()->success;
  }
  void onGo(const Text &) {
    ask();
    auto apart = separate_->async_send_request(std::make_shared<Trigger::Request>());
    apart.wait();
    auto poll = polled_->async_send_request(std::make_shared<Trigger::Request>());
    if (poll.wait_for(0s) == std::future_status::ready) poll.get();
    later_->async_send_request(std::make_shared<Trigger::Request>(), [this](rclcpp::Client<Trigger>::SharedFuture f) { ok_ = f.get()->success; });
  }
  void onGrouped(const Text &) {
    std::shared_future<Trigger::Response::SharedPtr> answer = other_->async_send_request(std::make_shared<Trigger::Request>()).future.share();
    rclcpp::spin_until_future_complete(shared_from_this(), answer);  // expect: finding callback-deadlock "*/other,*one callback group*"
  }
  void onTimer() {
    auto answer = reentrant_->async_send_request(std::make_shared<Trigger::Request>());
    answer.wait();  // expect: finding callback-deadlock "*/reentrant,*one thread runs all callbacks of the program"
    std::thread([this]() { ask(); }).detach();
  }
  bool ok_;
  rclcpp::CallbackGroup::SharedPtr group_, any_, apart_;
  rclcpp::Client<Trigger>::SharedPtr same_, polled_, later_, other_, reentrant_, separate_;
  rclcpp::Subscription<Text>::SharedPtr go_, grouped_;
  rclcpp::TimerBase::SharedPtr timer_;
};

void serve(const std::shared_ptr<Asker> & asker) { rclcpp::spin(asker); }

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  serve(std::make_shared<Asker>());
}
