// A listener without a thread, a filter with a callback, a buffer with a listener, filters that end with a constructor.
//
// expect: 1 = count : { misused(_, "no thread", _) }
// expect: 1 = count : { ends_too_early(_, "synchronizer") }
// expect: ends_too_early(S, "subscription"), port([S, _, "other"])
// expect: 2 = count : { ends_too_early(_, _) }
// expect-not: misused(_, "buffer alone", _); misused(_, "filter alone", _); misused(_, "lookup of now", _)
#include <memory>
#include <message_filters/subscriber.h>
#include <message_filters/time_synchronizer.h>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/image.hpp>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

using Image = sensor_msgs::msg::Image;

class Fuse : public rclcpp::Node {
public:
  Fuse() : Node("fuse") {
    message_filters::TimeSynchronizer<Image, Image> sync(left_, right_, 10);
    sync.registerCallback([](const Image::ConstSharedPtr&, const Image::ConstSharedPtr&) {});
    message_filters::Subscriber<Image> other(this, "other");
    kept_ = std::make_shared<message_filters::TimeSynchronizer<Image, Image>>(left_, other, 10);
    kept_->registerCallback([](const Image::ConstSharedPtr&, const Image::ConstSharedPtr&) {});
  }

private:
  message_filters::Subscriber<Image> left_;
  message_filters::Subscriber<Image> right_;
  std::shared_ptr<message_filters::TimeSynchronizer<Image, Image>> kept_;
};

class Look : public rclcpp::Node {
public:
  Look() : Node("look"), buffer_(get_clock()), listener_(buffer_, this, false), sync_(left_, right_, 10) {
    sync_.registerCallback(std::bind(&Look::both, this, std::placeholders::_1, std::placeholders::_2));
    timer_ = create_wall_timer(std::chrono::seconds(1), [this]() { tick(); });
  }

private:
  void both(const Image::ConstSharedPtr&, const Image::ConstSharedPtr&) {}
  void tick() {
    buffer_.lookupTransform("odom", "base_link", now(), rclcpp::Duration::from_seconds(1.0));
    if (buffer_.canTransform("odom", "base_link", now(), rclcpp::Duration::from_seconds(1.0))) {
      buffer_.lookupTransform("odom", "base_link", now());
    }
  }
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  message_filters::Subscriber<Image> left_;
  message_filters::Subscriber<Image> right_;
  message_filters::TimeSynchronizer<Image, Image> sync_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto fuse = std::make_shared<Fuse>();
  rclcpp::spin(std::make_shared<Look>());
}
