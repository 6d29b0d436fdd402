// What a call is given is made before the call, although it stands behind its name: the order of the text is not that of what is done.
//
// expect: 4 = count : { may_be_missed(_) }
#include <memory>
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/bool.hpp"

class Door : public rclcpp::Node
{
public:
  Door() : Node("door")
  {
    out_ = create_publisher<std_msgs::msg::Bool>("out", 1);
    go_ = create_subscription<std_msgs::msg::Bool>("go", 1, [this](std_msgs::msg::Bool::SharedPtr) {
      dark();
      light();
      set(next());
      level_ = raised();
    });
    ask_ = create_subscription<std_msgs::msg::Bool>("ask", 1, [this](std_msgs::msg::Bool::SharedPtr message) {
      if (mode_ == 2 && on_ && level_ == 7) {
        out_->publish(*message);
      }
    });
  }

private:
  int next()
  {
    mode_ = 1;
    return 3;
  }
  void set(int)
  {
    mode_ = 2;
  }
  int raised()
  {
    level_ = 4;
    return 7;
  }
  void light() {on_ = true;}
  void dark() {on_ = false;}

  int mode_ = 0;
  int level_ = 0;
  bool on_ = false;
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr out_;
  rclcpp::Subscription<std_msgs::msg::Bool>::SharedPtr go_;
  rclcpp::Subscription<std_msgs::msg::Bool>::SharedPtr ask_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Door>());
  rclcpp::shutdown();
}
