// A plug-in of Gazebo for ROS 2: its node is one that gazebo_ros makes of the plug-in's elements.
//
// expect: component_middleware("ROS 2")
#include <gazebo/common/Plugin.hh>
#include <gazebo_ros/node.hpp>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>

namespace sea
{
class CrabPrivate
{
public:
  void on_command(const std_msgs::msg::String &) {}

  gazebo_ros::Node::SharedPtr node_;
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
  rclcpp::Subscription<std_msgs::msg::String>::SharedPtr sub_;
};

class Crab : public gazebo::ModelPlugin
{
public:
  Crab() : impl_(std::make_unique<CrabPrivate>()) {}

  void Load(gazebo::physics::ModelPtr, sdf::ElementPtr sdf) override
  {
    impl_->node_ = gazebo_ros::Node::Get(sdf);
    auto qos = impl_->node_->get_qos();
    impl_->pub_ = impl_->node_->create_publisher<std_msgs::msg::String>("claw", qos.get_publisher_qos("claw", 1));  // expect: publisher claw std_msgs/String
    impl_->sub_ = impl_->node_->create_subscription<std_msgs::msg::String>(  // expect: subscriber command std_msgs/String callback=CrabPrivate::on_command
      "command", 1, std::bind(&CrabPrivate::on_command, impl_.get(), std::placeholders::_1));
  }

private:
  std::unique_ptr<CrabPrivate> impl_;
};

GZ_REGISTER_MODEL_PLUGIN(Crab)
}  // namespace sea
