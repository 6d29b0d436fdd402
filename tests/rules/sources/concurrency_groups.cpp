// An executor with several threads: callbacks of one exclusive group, by whatever name, take turns, and so do those of the node's own group; others may run at once.
//
// expect: concurrent_callbacks(F, G), function_name(F, "Robot::onA"), function_name(G, "Robot::onB")
// expect: concurrent_callbacks(F, G), function_name(F, "Robot::onB"), function_name(G, "Robot::onDefault")
// expect: concurrent_callbacks(F, G), function_name(F, "Robot::onFree"), function_name(G, "Robot::onFreeToo")
// expect: concurrent_callbacks(F, F), function_name(F, "Robot::onFree")
// expect-not: concurrent_callbacks(F, F), function_name(F, "Robot::onA")
// expect-not: concurrent_callbacks(F, F), function_name(F, "Robot::onDefault")
// expect-not: concurrent_callbacks(F, G), function_name(F, "Robot::onA"), function_name(G, "Robot::onAlias")
// expect-not: concurrent_callbacks(F, G), function_name(F, "Robot::onDefault"), function_name(G, "Robot::onDefaultToo")
// expect: changed_at_once(V, E, D), E != D, variable_name(V, "count_")
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/empty.hpp>

class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") {
    auto a = create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
    auto alias = a;
    auto b = create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive);
    auto free = create_callback_group(rclcpp::CallbackGroupType::Reentrant);
    rclcpp::SubscriptionOptions in_a, in_alias, in_b, in_free;
    in_a.callback_group = a;
    in_alias.callback_group = alias;
    in_b.callback_group = b;
    in_free.callback_group = free;
    subs_[0] = create_subscription<std_msgs::msg::Empty>("a", 1, std::bind(&Robot::onA, this, std::placeholders::_1), in_a);
    subs_[1] = create_subscription<std_msgs::msg::Empty>("alias", 1, std::bind(&Robot::onAlias, this, std::placeholders::_1), in_alias);
    subs_[2] = create_subscription<std_msgs::msg::Empty>("b", 1, std::bind(&Robot::onB, this, std::placeholders::_1), in_b);
    subs_[3] = create_subscription<std_msgs::msg::Empty>("free", 1, std::bind(&Robot::onFree, this, std::placeholders::_1), in_free);
    subs_[4] = create_subscription<std_msgs::msg::Empty>("free_too", 1, std::bind(&Robot::onFreeToo, this, std::placeholders::_1), in_free);
    subs_[5] = create_subscription<std_msgs::msg::Empty>("default", 1, std::bind(&Robot::onDefault, this, std::placeholders::_1));
    subs_[6] = create_subscription<std_msgs::msg::Empty>("default_too", 1, std::bind(&Robot::onDefaultToo, this, std::placeholders::_1));
    pub_ = create_publisher<std_msgs::msg::Empty>("out", 1);
  }

private:
  void onA(const std_msgs::msg::Empty& m) {
    count_ = 1;
    if (count_ > 0) pub_->publish(m);
  }
  void onAlias(const std_msgs::msg::Empty&) {}
  void onB(const std_msgs::msg::Empty&) { count_ = 0; }
  void onFree(const std_msgs::msg::Empty&) {}
  void onFreeToo(const std_msgs::msg::Empty&) {}
  void onDefault(const std_msgs::msg::Empty&) {}
  void onDefaultToo(const std_msgs::msg::Empty&) {}
  int count_ = 0;
  rclcpp::Publisher<std_msgs::msg::Empty>::SharedPtr pub_;
  rclcpp::Subscription<std_msgs::msg::Empty>::SharedPtr subs_[7];
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Robot>();
  rclcpp::executors::MultiThreadedExecutor executor;
  executor.add_node(node);
  executor.spin();
}
