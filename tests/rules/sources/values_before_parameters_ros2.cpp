// What ports are told by members that begin otherwise than they are once parameters have been read: in any case, under a condition, or with what they begin with.
//
// expect-only: subscriber *
// expect: subscriber laser std_msgs/Empty queue=7
// expect: subscriber sonar std_msgs/Empty
// expect: subscriber bumper std_msgs/Empty
// expect: subscriber cliff std_msgs/Empty
// expect: subscriber wheel std_msgs/Empty
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/empty.hpp>
#include <string>

class Guard : public rclcpp::Node
{
public:
  Guard() : Node("guard")
  {
  }
  void configure(bool near)
  {
    scan_ = declare_parameter("scan", std::string("laser"));
    depth_ = declare_parameter("depth", 7);
    if (near) {
      range_ = declare_parameter("range", std::string("bumper"));
    }
    edge_ = declare_parameter("edge", edge_);
    get_parameter_or("odometry", odometry_, std::string("wheel"));
    subscribe();
  }

private:
  void subscribe()
  {
    subs_[0] = create_subscription<std_msgs::msg::Empty>(scan_, depth_, std::bind(&Guard::on, this, std::placeholders::_1));
    subs_[1] = create_subscription<std_msgs::msg::Empty>(range_, 1, std::bind(&Guard::on, this, std::placeholders::_1));
    subs_[2] = create_subscription<std_msgs::msg::Empty>(edge_, 1, std::bind(&Guard::on, this, std::placeholders::_1));
    subs_[3] = create_subscription<std_msgs::msg::Empty>(odometry_, 1, std::bind(&Guard::on, this, std::placeholders::_1));
  }
  void on(std_msgs::msg::Empty::ConstSharedPtr)
  {
  }
  std::string scan_ = "camera", range_ = "sonar", edge_{"cliff"}, odometry_ = "gyro";
  int depth_ = 3;
  rclcpp::Subscription<std_msgs::msg::Empty>::SharedPtr subs_[4];
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Guard>();
  node->configure(argc > 1);
  rclcpp::spin(node);
}
