// A program that makes nodes of the classes that its libraries register.
//
// expect: unseen("ports", "factory", "create_node_instance", _, 17, _)
// expect: unseen("params", "factory", "create_node_instance", _, 17, _)
#include <class_loader/class_loader.hpp>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/node_factory.hpp>

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::executors::SingleThreadedExecutor exec;
  auto asked = std::make_shared<rclcpp::Node>("asked");
  bool verbose = asked->declare_parameter("verbose", false);
  class_loader::ClassLoader loader("");
  for (auto name : loader.getAvailableClasses<rclcpp_components::NodeFactory>()) {
    auto factory = loader.createInstance<rclcpp_components::NodeFactory>(name);
    auto node = factory->create_node_instance(rclcpp::NodeOptions());
    exec.add_node(node.get_node_base_interface());
  }
  if (verbose) exec.spin();
}
