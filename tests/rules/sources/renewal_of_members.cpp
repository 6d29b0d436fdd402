// What functions return, and what is given to new objects: state only where it tells of what was before.
// expect-only: state *
#include <memory>
#include <optional>
#include <string>
#include <vector>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/float32.hpp>
#include <std_msgs/msg/string.hpp>

using Number = std_msgs::msg::Float32;
using Text = std_msgs::msg::String;

// expect: state Zone::enabled_
class Zone {
public:
  bool configure(double radius) {
    clock_ = 1;
    radius_ = radius;
    if (radius_ <= 0.0) return false;
    enabled_ = true;  // expect: transition enabled_ = true
    helped();
    return true;
  }
  void disable() { enabled_ = false; }  // expect: transition enabled_ = false
  bool active() const { return enabled_ && clock_ > 0 && side_ > 0 && radius_ > 0; }

private:
  void helped() { side_ = 2; }
  bool enabled_ = false;
  int clock_ = 0;
  int side_ = 0;
  double radius_ = 0;
};

class Painter : public rclcpp::Node {
public:
  Painter() : Node("painter") {
    told_ = create_publisher<Text>("told", 1);
    add_ = create_subscription<Number>("add", 1, [this](const Number & n) {
      auto zone = std::make_shared<Zone>();
      if (!zone->configure(n.data)) return;
      zones_.push_back(zone);  // expect: transition zones_ on add
    });
    stop_ = create_subscription<Number>("stop", 1, [this](const Number &) { for (auto & zone : zones_) zone->disable(); });
    draw_ = create_subscription<Number>("draw", 1, [this](const Number & n) {
      if (!picture(n.data).empty()) told_->publish(Text());
      for (auto & zone : zones_) if (zone->active()) told_->publish(Text());
      if (best_) told_->publish(Text());
      best_.reset();  // expect: transition best_ on draw
    });
    keep_ = create_subscription<Number>("keep", 1, [this](const Number & n) {
      best_ = n.data;
      if (last_ > n.data) told_->publish(Text());
      last_ = n.data;
    });
  }
  // expect: state Painter::zones_
  // expect: state Painter::best_
  // expect: state Painter::last_

private:
  const std::string & picture(double size) {
    buffer_ = "";
    if (size > 1) buffer_ = "big";
    return buffer_;
  }
  std::string buffer_;
  std::optional<float> best_;
  float last_ = 0;
  std::vector<std::shared_ptr<Zone>> zones_;
  rclcpp::Publisher<Text>::SharedPtr told_;
  rclcpp::Subscription<Number>::SharedPtr add_, stop_, draw_, keep_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Painter>());
}
