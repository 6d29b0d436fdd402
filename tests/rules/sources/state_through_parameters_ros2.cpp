// What a condition depends on through a part of a parameter that the function itself gives a value.
//
// expect: state B::last_
// expect: transition B::last_ = pose on odom
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>
#include <nav_msgs/msg/odometry.hpp>

struct Pose
{
  double v[3];
};

class B : public rclcpp::Node
{
public:
  B() : Node("b")
  {
    pub_ = create_publisher<std_msgs::msg::Bool>("moved", 1);
    sub_ = create_subscription<nav_msgs::msg::Odometry>("odom", 1, std::bind(&B::onOdom, this, std::placeholders::_1));
  }

private:
  void onOdom(nav_msgs::msg::Odometry::ConstSharedPtr msg)
  {
    Pose pose, delta;
    pose.v[0] = msg->pose.pose.position.x;
    if (moved(pose, delta)) {
      pub_->publish(std_msgs::msg::Bool());
      last_ = pose;
    }
  }
  bool moved(const Pose pose, Pose & delta)
  {
    delta.v[0] = pose.v[0] - last_.v[0];
    bool update = std::fabs(delta.v[0]) > 0.2;
    return update;
  }
  Pose last_;
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr pub_;
  rclcpp::Subscription<nav_msgs::msg::Odometry>::SharedPtr sub_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<B>());
}
