// What ends with the function that makes it: held by a local variable, or by nothing. What something else holds as well, what the function waits with, and what only main holds, lasts.
//
// expect: ends_too_early(S, "subscription"), port([S, _, "local"])
// expect: ends_too_early(S, "subscription"), port([S, _, "nothing"])
// expect: ends_too_early(S, "subscription"), port([S, _, "late"])
// expect: ends_too_early(S, "service"), port([S, _, "service"])
// expect: ends_too_early(S, "action server"), port([S, _, "act"])
// expect: ends_too_early(S, "client"), port([S, _, "ask"])
// expect: ends_too_early(S, "client"), port([S, "action_client", "act"])
// expect: ends_too_early(S, "publisher"), port([S, _, "lost"])
// expect: 1 = count : { ends_too_early(_, "broadcaster") }, 1 = count : { ends_too_early(_, "timer") }, 1 = count : { ends_too_early(_, "parameter callback") }
// expect: 2 = count : { ends_too_early(_, "callback group") }, 13 = count : { ends_too_early(_, _) }
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_action/rclcpp_action.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_srvs/srv/trigger.hpp>
#include <tf2_ros/transform_broadcaster.h>
#include <tf2_msgs/action/lookup_transform.hpp>

using Bool = std_msgs::msg::Bool;
using Trigger = std_srvs::srv::Trigger;
using Lookup = tf2_msgs::action::LookupTransform;
using Goal = rclcpp_action::ServerGoalHandle<Lookup>;

class Lamp : public rclcpp::Node {
public:
  Lamp() : Node("lamp") {
    auto on = [this](Bool::ConstSharedPtr) { count_++; };
    auto answer = [this](Trigger::Request::SharedPtr, Trigger::Response::SharedPtr) { count_++; };
    auto sub = create_subscription<Bool>("local", 1, on);
    create_subscription<Bool>("nothing", 1, on);
    rclcpp::Subscription<Bool>::SharedPtr late;
    late = create_subscription<Bool>("late", 1, on);
    auto service = create_service<Trigger>("service", answer);
    rclcpp::TimerBase::SharedPtr timer = create_wall_timer(std::chrono::seconds(1), [this] { count_++; });
    auto server = rclcpp_action::create_server<Lookup>(this, "act", &Lamp::onGoal, &Lamp::onCancel, &Lamp::onAccepted);
    auto handle = add_on_set_parameters_callback([](const std::vector<rclcpp::Parameter>&) { return rcl_interfaces::msg::SetParametersResult(); });
    auto group = create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
    grouped_ = create_service<Trigger>("grouped", answer, rclcpp::ServicesQoS(), group);
    timer_ = create_wall_timer(std::chrono::seconds(1), [this] { again(); }, create_callback_group(rclcpp::CallbackGroupType::Reentrant));
    // a subscription holds its options, and with them the group
    auto held = create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
    rclcpp::SubscriptionOptions options;
    options.callback_group = held;
    sub_ = create_subscription<Bool>("member", 1, on, options);
    // given to something else
    auto listed = create_subscription<Bool>("listed", 1, on);
    subs_.push_back(listed);
    subs_.push_back(create_subscription<Bool>("pushed", 1, on));
    auto captured = create_subscription<Bool>("captured", 1, on);
    keep_ = [captured] {};
    auto& element = subs_.emplace_back();
    element = create_subscription<Bool>("element", 1, on);
    static auto lasting = create_subscription<Bool>("static", 1, on);
    auto shared = sharedGroup();
    other_ = create_service<Trigger>("other", answer, rclcpp::ServicesQoS(), shared);
    other_timer_ = create_wall_timer(std::chrono::seconds(1), [this] { waits(); });
  }

  rclcpp::Subscription<Bool>::SharedPtr returned() {
    auto sub = create_subscription<Bool>("returned", 1, [this](Bool::ConstSharedPtr) { count_++; });
    return sub;
  }

  void whileItWaits() {
    auto sub = create_subscription<Bool>("awaited", 1, [this](Bool::ConstSharedPtr) { count_++; });
    while (count_ == 0) rclcpp::sleep_for(std::chrono::seconds(1));
  }

private:
  void again() {
    auto client = create_client<Trigger>("ask");
    client->wait_for_service(std::chrono::seconds(1));
    client->async_send_request(std::make_shared<Trigger::Request>(), [this](rclcpp::Client<Trigger>::SharedFuture) { count_++; });
    // a goal, with a callback in the options
    auto actions = rclcpp_action::create_client<Lookup>(this, "act");
    rclcpp_action::Client<Lookup>::SendGoalOptions options;
    options.result_callback = [this](const rclcpp_action::ClientGoalHandle<Lookup>::WrappedResult&) { count_++; };
    actions->async_send_goal(Lookup::Goal(), options);
    // sent at once
    auto pub = create_publisher<Bool>("lost", 1);
    pub->publish(Bool());
    tf2_ros::TransformBroadcaster broadcaster(this);
    broadcaster.sendTransform(geometry_msgs::msg::TransformStamped());
    // a static one, one that captures hold, and one whose answer is waited for
    static auto kept = create_publisher<Bool>("kept", 1);
    kept->publish(Bool());
    auto patient = create_client<Trigger>("patient");
    patient->async_send_request(std::make_shared<Trigger::Request>(), [patient](rclcpp::Client<Trigger>::SharedFuture) {});
  }
  void waits() {
    auto waited = create_client<Trigger>("waited");
    auto future = waited->async_send_request(std::make_shared<Trigger::Request>(), [this](rclcpp::Client<Trigger>::SharedFuture) { count_++; });
    future.wait();
  }
  rclcpp::CallbackGroup::SharedPtr sharedGroup() { return group_ = create_callback_group(rclcpp::CallbackGroupType::Reentrant); }
  static rclcpp_action::GoalResponse onGoal(const rclcpp_action::GoalUUID&, std::shared_ptr<const Lookup::Goal>) { return rclcpp_action::GoalResponse::REJECT; }
  static rclcpp_action::CancelResponse onCancel(std::shared_ptr<Goal>) { return rclcpp_action::CancelResponse::REJECT; }
  static void onAccepted(std::shared_ptr<Goal>) {}

  int count_ = 0;
  std::function<void()> keep_;
  rclcpp::CallbackGroup::SharedPtr group_;
  rclcpp::TimerBase::SharedPtr timer_, other_timer_;
  rclcpp::Service<Trigger>::SharedPtr grouped_, other_;
  rclcpp::Subscription<Bool>::SharedPtr sub_;
  std::vector<rclcpp::Subscription<Bool>::SharedPtr> subs_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Lamp>();
  auto sub = node->create_subscription<Bool>("of_main", 1, [](Bool::ConstSharedPtr) {});
  auto other = node->returned();
  node->whileItWaits();
  rclcpp::spin(node);
}
