// Callbacks that functions make, each of which calls the one that it was given.
// expect-only: reactive * -> *
// expect: port_flow([_, _, "scan"], [_, _, "near"], "data", _)
// expect-not: port_flow([_, _, "scan"], [_, _, "pose"], _, _); port_flow([_, _, "odom"], [_, _, "near"], _, _)
// expect: perhaps_always([_, _, "scan"], [_, _, "near"])
// expect: always_reacts([_, _, "alone"], [_, _, "only"])
// expect: always_reacts([_, _, "held"], [_, _, "first"])
#include <functional>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>

using Text = std_msgs::msg::String;
using Callback = std::function<void(Text::ConstSharedPtr)>;

class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") {
    near_ = create_publisher<Text>("near", 1);
    pose_ = create_publisher<Text>("pose", 1);
    only_ = create_publisher<Text>("only", 1);
    first_ = create_publisher<Text>("first", 1);
    scan_ = create_subscription<Text>("scan", 1, guarded(std::bind(&Robot::onScan, this, std::placeholders::_1)));
    odom_ = create_subscription<Text>("odom", 1, guarded([this](Text::ConstSharedPtr m) { pose_->publish(*m); }));  // expect: reactive odom -> pose
    alone_ = create_subscription<Text>("alone", 1, sendsOn(only_));
    held_ = create_subscription<Text>("held", 1, chosen());
  }

private:
  Callback guarded(Callback inner) {
    return [this, inner](Text::ConstSharedPtr m) {
      if (ready_) inner(m);
    };
  }

  Callback sendsOn(rclcpp::Publisher<Text>::SharedPtr pub) {
    return [pub](Text::ConstSharedPtr m) { pub->publish(*m); };  // expect: reactive alone -> only
  }

  Callback chosen() {
    Callback made = [this](Text::ConstSharedPtr m) { first_->publish(*m); };  // expect: reactive held -> first
    return made;
  }

  void onScan(Text::ConstSharedPtr m) { near_->publish(*m); }  // expect: reactive scan -> near

  bool ready_ = true;
  rclcpp::Publisher<Text>::SharedPtr near_, pose_, only_, first_;
  rclcpp::Subscription<Text>::SharedPtr scan_, odom_, alone_, held_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
}
