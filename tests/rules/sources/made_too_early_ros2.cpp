// What a constructor asks too early, and parameters that are declared twice. Not told: what only a callback does, what is handled, and what a condition decides.
//
// expect: 2 = count : { shared_too_early(_) }
// expect: declared_twice(_, _, "rate")
// expect: 1 = count : { declared_twice(_, _, _) }
#include <rclcpp/rclcpp.hpp>

class Watch : public rclcpp::Node {
public:
  Watch() : Node("watch") {
    self_ = shared_from_this();
    prepare();
    timer_ = create_wall_timer(std::chrono::seconds(1), [this]() { self_ = shared_from_this(); });
    declare_parameter("rate", 1.0);
    declare_parameter("limit", 1.0);
    declare_parameter("rate", 2.0);
    try {
      declare_parameter("limit", 2.0);
    } catch (const rclcpp::exceptions::ParameterAlreadyDeclaredException&) {
    }
    declare_parameter("size", 1);
    if (!has_parameter("size")) declare_parameter("size", 2);
  }
  void later() { self_ = shared_from_this(); }

private:
  void prepare() { self_ = this->shared_from_this(); }
  std::shared_ptr<rclcpp::Node> self_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Watch>();
  node->later();
  rclcpp::spin(node);
}
