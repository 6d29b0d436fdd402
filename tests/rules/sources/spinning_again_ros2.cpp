// Callbacks that spin the node that they belong to, and two that spin another one, or the executor itself.
//
// expect: spins_again(C, "thrown"), expr_function(C, F), function_name(F, "Ward::onAlarm")
// expect: spins_again(C, "thrown"), expr_function(C, F), function_name(F, "Ward::look")
// expect: spins_again(C, "thrown"), expr_function(C, F), function_name(F, "onCall")
// expect: 3 = count : { spins_again(_, _) }
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>

using Bool = std_msgs::msg::Bool;
rclcpp::Node::SharedPtr g_node, g_other;

class Ward : public rclcpp::Node {
public:
  explicit Ward(rclcpp::Executor& executor) : Node("ward"), executor_(executor), helper_(std::make_shared<rclcpp::Node>("helper")) {
    sub_ = create_subscription<Bool>("alarm", 1, std::bind(&Ward::onAlarm, this, std::placeholders::_1));
    timer_ = create_wall_timer(std::chrono::seconds(1), [this] { look(); });
    slow_ = create_wall_timer(std::chrono::seconds(9), [this] { ask(); });
  }

private:
  void onAlarm(const Bool&) { rclcpp::spin_some(shared_from_this()); }
  void look() { rclcpp::spin_some(get_node_base_interface()); }
  void ask() {
    rclcpp::spin_some(helper_);
    executor_.spin_some();
  }
  rclcpp::Executor& executor_;
  rclcpp::Node::SharedPtr helper_;
  rclcpp::TimerBase::SharedPtr timer_, slow_;
  rclcpp::Subscription<Bool>::SharedPtr sub_;
};

void onCall(const Bool&) {
  rclcpp::spin_some(g_node);
  rclcpp::spin_some(g_other);
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  g_node = std::make_shared<rclcpp::Node>("caller");
  g_other = std::make_shared<rclcpp::Node>("other");
  auto sub = g_node->create_subscription<Bool>("call", 1, onCall);
  rclcpp::executors::SingleThreadedExecutor executor;
  auto ward = std::make_shared<Ward>(executor);
  rclcpp::spin_some(ward);
  executor.add_node(ward);
  executor.add_node(g_node);
  executor.spin();
}
