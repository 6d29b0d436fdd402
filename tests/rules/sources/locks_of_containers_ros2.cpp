// Containers that callbacks of a reentrant group change at once.
//
// expect: remade_at_once("points_", E, D), E != D
// expect-not: remade_at_once("guarded_", _, _)
// expect-not: remade_at_once("elements_", _, _)
// expect-not: remade_at_once("apart_", _, _)
#include <array>
#include <memory>
#include <mutex>
#include <vector>
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/float64.hpp"

class Pile : public rclcpp::Node
{
public:
  Pile() : Node("pile"), elements_(4)
  {
    group_ = create_callback_group(rclcpp::CallbackGroupType::Reentrant);
    rclcpp::SubscriptionOptions options;
    options.callback_group = group_;
    sub_ = create_subscription<std_msgs::msg::Float64>("range", 10,
      [this](std_msgs::msg::Float64::ConstSharedPtr m) { add(m->data); }, options);
    timer_ = create_wall_timer(std::chrono::milliseconds(100), [this]() { flush(); }, group_);
    slow_ = create_wall_timer(std::chrono::seconds(1), [this]() { apart_.clear(); });
    other_ = create_wall_timer(std::chrono::seconds(2), [this]() { apart_.push_back(1.0); });
    keep_ = create_wall_timer(std::chrono::seconds(2), [this]() { std::lock_guard<std::mutex> lock(mutex_); guarded_.clear(); }, group_);
    more_ = create_wall_timer(std::chrono::seconds(3), [this]() { std::lock_guard<std::mutex> lock(mutex_); guarded_.push_back(1.0); }, group_);
  }

private:
  void add(double value)
  {
    points_.push_back(value);
    elements_[0] = value;
  }
  void flush()
  {
    points_.clear();
    elements_[1] = 0.0;
  }
  std::vector<double> points_;
  std::vector<double> guarded_;
  std::vector<double> elements_;
  std::vector<double> apart_;
  std::mutex mutex_;
  rclcpp::CallbackGroup::SharedPtr group_;
  rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr sub_;
  rclcpp::TimerBase::SharedPtr timer_, slow_, other_, keep_, more_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Pile>();
  rclcpp::executors::MultiThreadedExecutor executor;
  executor.add_node(node);
  executor.spin();
  rclcpp::shutdown();
}
