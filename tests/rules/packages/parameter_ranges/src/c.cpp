// expect: component c package=parameter_ranges
#include <rclcpp/rclcpp.hpp>
class C : public rclcpp::Node
{
public:
  C() : Node("c")
  {
    rcl_interfaces::msg::ParameterDescriptor descriptor;
    rcl_interfaces::msg::FloatingPointRange range;
    range.from_value = 0.0;
    range.to_value = 5.0;
    descriptor.floating_point_range.push_back(range);
    declare_parameter("speed", 1.0, descriptor);
    rcl_interfaces::msg::ParameterDescriptor other;
    other.integer_range.resize(1);
    other.integer_range[0].from_value = -2;
    other.integer_range[0].to_value = 2;
    declare_parameter<int>("turn", 1, other);
    rcl_interfaces::msg::ParameterDescriptor d3;
    d3.floating_point_range = {range};
    declare_parameter("d3", 1.0, d3);
  }
};
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<C>());
}
