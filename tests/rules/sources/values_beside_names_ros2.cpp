// Names that are made of others, and the callback that a template wraps: a pointer to a method.
//
// expect: subscriber rgb/image_rect
// expect: subscriber rgb/camera_info
// expect: subscriber camera_info
// expect: subscriber scan callback=Camera::onScan
// expect-only: subscriber
// expect: reactive scan -> seen
#include <functional>
#include <image_transport/image_transport.hpp>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/camera_info.hpp>
#include <sensor_msgs/msg/image.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <std_msgs/msg/bool.hpp>

class Camera : public rclcpp::Node
{
public:
  Camera();

  void onScan(int sensor, const sensor_msgs::msg::LaserScan::SharedPtr&)
  {
    if (sensor == 1)
      seen_->publish(std_msgs::msg::Bool());
  }

private:
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr seen_;
  std::vector<rclcpp::SubscriptionBase::SharedPtr> kept_;
};

template <class M>
rclcpp::SubscriptionBase::SharedPtr with(void (Camera::*handler)(int, const typename M::SharedPtr&), int sensor, const std::string& topic, Camera* node)
{
  return node->create_subscription<M>(
    topic, 1, std::function<void(const typename M::SharedPtr)>([node, handler, sensor](const typename M::SharedPtr msg) { (node->*handler)(sensor, msg); }));
}

Camera::Camera() : Node("camera")
{
  using sensor_msgs::msg::CameraInfo;
  seen_ = create_publisher<std_msgs::msg::Bool>("seen", 1);
  std::string image = get_node_base_interface()->resolve_topic_or_service_name("rgb/image_rect", false);
  kept_.push_back(create_subscription<sensor_msgs::msg::Image>(image, 1, [](sensor_msgs::msg::Image::SharedPtr) {}));
  kept_.push_back(create_subscription<CameraInfo>(image_transport::getCameraInfoTopic(image), 1, [](CameraInfo::SharedPtr) {}));
  kept_.push_back(create_subscription<CameraInfo>(image_transport::getCameraInfoTopic("image"), 1, [](CameraInfo::SharedPtr) {}));
  kept_.push_back(with<sensor_msgs::msg::LaserScan>(&Camera::onScan, 1, "scan", this));
}

int main(int argc, char** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Camera>());
}
