// Of constructors with one parameter the one that takes what make_shared is given, so that it is certainly run.
//
// expect: done_at_start(C), call(C, "declare_parameter")
// expect: param rate
#include <rclcpp/rclcpp.hpp>

struct Left {};

class Listener {
 public:
  explicit Listener(const std::shared_ptr<Left>&) {}
  explicit Listener(const rclcpp::Node::SharedPtr& node) { node->declare_parameter("rate", 1); }
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("motor");
  auto listener = std::make_shared<Listener>(node);
  rclcpp::spin(node);
}
