// Functions of another namespace that a template calls by their bare names, after a using-declaration.
//
// expect: param wheel_radius
// expect: param wheel_width
#include <memory>
#include <string>
#include <rclcpp/rclcpp.hpp>
namespace tools {
template <class T, class N>
T get_or_declare(N & node, const std::string & name)
{
  if (node.has_parameter(name)) {
    return node.get_parameter(name).template get_value<T>();
  }
  return node.template declare_parameter<T>(name);
}
}
class Vehicle
{
public:
  template <typename NodeT>
  explicit Vehicle(NodeT & node)
  {
    using tools::get_or_declare;
    radius_ = get_or_declare<double>(node, "wheel_radius");
    width_ = tools::get_or_declare<double>(node, "wheel_width");
  }
  double radius_, width_;
};
class Ground : public rclcpp::Node
{
public:
  Ground() : Node("ground") {
    info_ = Vehicle(*this).radius_;
  }
private:
  double info_;
};
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Ground>());
}
