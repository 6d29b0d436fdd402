// What initialises a field where it is declared runs when an object of its class is made: not that of a class that the program has no object of.
//
// expect: publisher state std_msgs/Bool
// expect: publisher battery std_msgs/Bool
// expect: subscriber limit std_msgs/Bool
// expect-only: publisher * std_msgs/Bool
// expect: reactive limit -> state
// expect: periodic battery 1 Hz
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>

using std_msgs::msg::Bool;

class Unused : public rclcpp::Node
{
public:
  Unused() : Node("unused") {}

private:
  rclcpp::Publisher<Bool>::SharedPtr lost_ = create_publisher<Bool>("lost", 1);
  rclcpp::Publisher<Bool>::SharedPtr gone_{create_publisher<Bool>("gone", 1)};
};

// without a constructor
struct Battery
{
  rclcpp::Node * node;
  rclcpp::Publisher<Bool>::SharedPtr publisher = node->create_publisher<Bool>("battery", 1);
  rclcpp::TimerBase::SharedPtr timer = node->create_wall_timer(std::chrono::seconds(1), [this] { publisher->publish(Bool()); });
};

class Base : public rclcpp::Node
{
public:
  Base() : Node("base") {}

private:
  rclcpp::Publisher<Bool>::SharedPtr state_ = create_publisher<Bool>("state", 1);
  rclcpp::Subscription<Bool>::SharedPtr limit_ = create_subscription<Bool>("limit", 1, [this](Bool::ConstSharedPtr limit) { state_->publish(*limit); });
  Battery battery_{this};
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Base>());
}
