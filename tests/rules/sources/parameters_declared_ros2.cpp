// A parameter that is declared with a default has it wherever it is read, whatever the reader has for a parameter without a value.
//
// expect: param speed = 5 op=declare
// expect: param speed = 5 op=read
// expect: param rate = 10 op=read
// expect: param gain = 2 op=read
// expect: param frame op=declare
// expect: param frame = map op=read
// expect-only: param * op=read
#include <rclcpp/rclcpp.hpp>
#include <string>

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("robot");
  node->declare_parameter("speed", 5);
  node->declare_parameter("rate", 10);
  node->declare_parameter("gain", 2);
  node->declare_parameter<std::string>("frame");
  auto speed = node->get_parameter("speed").as_int();
  int rate = 0;
  node->get_parameter("rate", rate);
  int gain;
  node->get_parameter_or("gain", gain, 7);
  std::string frame;
  node->get_parameter_or<std::string>("frame", frame, "map");
  RCLCPP_INFO(node->get_logger(), "%ld %d %d %s", speed, rate, gain, frame.c_str());
  rclcpp::spin(node);
}
