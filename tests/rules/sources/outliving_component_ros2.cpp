// A component that joins a thread which ends only with ROS.
//
// expect: 1 = count : { joins_endless(_, _, _) }
// expect: joins_endless(_, _, "thread_")
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <thread>

namespace kitchen {
class Oven : public rclcpp::Node {
public:
  explicit Oven(const rclcpp::NodeOptions& options) : Node("oven", options), thread_(&Oven::bake, this) {}
  ~Oven() override {
    if (thread_.joinable()) thread_.join();
  }

private:
  void bake() {
    rclcpp::Rate rate(10);
    while (rclcpp::ok()) {
      rate.sleep();
    }
  }
  std::thread thread_;
};
}  // namespace kitchen
RCLCPP_COMPONENTS_REGISTER_NODE(kitchen::Oven)
