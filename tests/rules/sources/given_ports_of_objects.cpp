// Functions that send through what they are given: a parameter, or a member of the object that they are called on.
// expect-only: reactive * -> *
// expect: 6 = count : { default_group(_, _) }, 2 = count : { given_to_another(_, _, _) }
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
#include <std_srvs/srv/trigger.hpp>

using Text = std_msgs::msg::String;
using Trigger = std_srvs::srv::Trigger;

struct Horn { using Message = Text; static constexpr char name[] = "horn"; };
struct Lamp { using Message = Text; static constexpr char name[] = "lamp"; };
struct Bell { using Message = Text; static constexpr char name[] = "bell"; };

// which port it is the template tells
template <class Spec>
class Output {
public:
  using SharedPtr = std::shared_ptr<Output>;
  explicit Output(rclcpp::Node * node) { pub_ = node->create_publisher<typename Spec::Message>(Spec::name, 1); }
  void publish(const Text & text) { pub_->publish(text); }
  void twice(const Text & text) { this->publish(text); this->publish(text); }

private:
  typename rclcpp::Publisher<typename Spec::Message>::SharedPtr pub_;
};

template <class OutputT>
void forward(OutputT & output, const Text & text) { output->publish(text); }

// which port it is the constructor is told
class Motor {
public:
  Motor(rclcpp::Node * node, const std::string & side) {
    pub_ = node->create_publisher<Text>(side + "/speed", 1);
    sub_ = node->create_subscription<Text>(side + "/turns", 1, std::bind(&Motor::turns, this, std::placeholders::_1));
  }
  void run() { if (ready_) send(); }
  void halt() { send(); }

private:
  void send() { pub_->publish(Text()); }
  void turns(const Text &) { send(); }

  bool ready_;
  rclcpp::Publisher<Text>::SharedPtr pub_;
  rclcpp::Subscription<Text>::SharedPtr sub_;
};
// expect: reactive left/turns -> left/speed
// expect: reactive right/turns -> right/speed

class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot"), left_(this, "left"), right_(this, "right") {
    horn_ = std::make_shared<Output<Horn>>(this);
    lamp_ = std::make_shared<Output<Lamp>>(this);
    bell_ = std::make_shared<Output<Bell>>(this);
    loud_ = create_subscription<Text>("loud", 1, [this](const Text & text) { horn_->publish(text); });
    // expect: reactive loud -> horn must
    dark_ = create_subscription<Text>("dark", 1, [this](const Text & text) { forward(lamp_, text); });
    // expect: reactive dark -> lamp must
    late_ = create_subscription<Text>("late", 1, [this](const Text & text) { bell_->twice(text); });
    // expect: reactive late -> bell must
    go_ = create_service<Trigger>("go", [this](Trigger::Request::SharedPtr, Trigger::Response::SharedPtr) { left_.run(); });
    // expect: reactive go -> left/speed may
    stop_ = create_service<Trigger>("stop", [this](Trigger::Request::SharedPtr, Trigger::Response::SharedPtr) { left_.halt(); right_.halt(); });
    // expect: reactive stop -> left/speed must
    // expect: reactive stop -> right/speed must
  }

private:
  Output<Horn>::SharedPtr horn_;
  Output<Lamp>::SharedPtr lamp_;
  Output<Bell>::SharedPtr bell_;
  Motor left_, right_;
  rclcpp::Subscription<Text>::SharedPtr loud_, dark_, late_;
  rclcpp::Service<Trigger>::SharedPtr go_, stop_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
}
