// A light tells its colour, which decides what it is next: it is in modes. What it has counted becomes another number each time: that is no mode.
#include <ros/ros.h>
#include <std_msgs/UInt8.h>

enum Color { RED, GREEN };

class Light {
public:
  Light() {
    color_pub_ = nh_.advertise<std_msgs::UInt8>("color", 1);
    count_pub_ = nh_.advertise<std_msgs::UInt8>("count", 1);
    next_sub_ = nh_.subscribe("next", 1, &Light::onNext, this);
  }

private:
  void onNext(const std_msgs::UInt8&) {
    if (color_ == RED) color_ = GREEN;
    else color_ = RED;
    std_msgs::UInt8 color;
    color.data = color_;
    color_pub_.publish(color);
    if (count_ < 3) count_ = count_ + 1;
    else count_ = 0;
    std_msgs::UInt8 count;
    count.data = count_;
    count_pub_.publish(count);
  }

  ros::NodeHandle nh_;
  ros::Publisher color_pub_, count_pub_;
  ros::Subscriber next_sub_;
  Color color_ = RED;
  int count_ = 0;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "light");
  Light light;
  ros::spin();
}
// expect: reactive next -> color must []
// expect: reactive next -> count must []
// expect: state Light::color_ = RED
// expect: transition Light::color_ . None on next [!(color_ == RED)] := RED
// expect: transition Light::color_ . None on next [color_ == RED] := GREEN
