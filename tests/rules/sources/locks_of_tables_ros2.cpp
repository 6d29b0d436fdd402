// A table of texts, of which a function gives one as a part of another text: what is done to the copy does not change the table.
//
// expect: changed_at_once(V, _, _), variable_name(V, "sent_")
// expect-not: changed_at_once(V, _, _), variable_name(V, "names")
// expect-not: changed_at_once(V, _, _), variable_name(V, "levels")
#include <memory>
#include <string>
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/string.hpp"

std::string command(int which, int level)
{
  static std::string names[] = { "open", "close" };
  static int levels[] = { 1, 2 };
  std::string text = "IO[" + names[which] + "]=" + std::to_string(levels[level]);
  return text;
}

struct Packet
{
  std::string text;
};

void fill(Packet & packet, const std::string & text, bool keep)
{
  packet.text = text;
  if (!keep) {
    packet.text.clear();
  }
}

class Sender : public rclcpp::Node
{
public:
  Sender() : Node("sender")
  {
    group_ = create_callback_group(rclcpp::CallbackGroupType::Reentrant);
    rclcpp::SubscriptionOptions options;
    options.callback_group = group_;
    pub_ = create_publisher<std_msgs::msg::String>("out", 10);
    sub_ = create_subscription<std_msgs::msg::String>(
      "in", 10, [this](std_msgs::msg::String::ConstSharedPtr m) { send(m->data.size()); }, options);
    timer_ = create_wall_timer(std::chrono::milliseconds(100), [this]() { send(0); }, group_);
  }

private:
  void send(int which)
  {
    std::string text = command(which, which);
    Packet packet;
    fill(packet, text, true);
    if (sent_ > 3 || text == "IO[open]=1") {
      return;
    }
    sent_ += which;
    std_msgs::msg::String out;
    out.data = packet.text;
    pub_->publish(out);
    text.clear();
  }
  int sent_ = 0;
  rclcpp::CallbackGroup::SharedPtr group_;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr sub_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Sender>();
  rclcpp::executors::MultiThreadedExecutor executor;
  executor.add_node(node);
  executor.spin();
  rclcpp::shutdown();
}
