// expect: component placed_in_cpp package=beginnings
// expect: publisher cmd std_msgs/String
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
class Placed : public rclcpp::Node
{
public:
  Placed() : Node("placed", "jet")
  {
    pub_ = create_publisher<std_msgs::msg::String>("cmd", 1);
    pub_->publish(std_msgs::msg::String());
  }
  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr pub_;
};
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Placed>());
}
