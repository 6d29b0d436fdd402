// Point clouds through point_cloud_transport, as the newest version of rclcpp has it, and for older ones otherwise.
//
// expect: subscriber near sensor_msgs/PointCloud2 queue=10 callback=Clouds::onNear via=point_cloud_transport
// expect: subscriber far sensor_msgs/PointCloud2 queue=5 via=point_cloud_transport
// expect: subscriber picture sensor_msgs/Image queue=3 callback=Clouds::onPicture
// expect-not: subscriber old
#include <image_transport/image_transport.hpp>
#include <point_cloud_transport/point_cloud_transport.hpp>
#include <point_cloud_transport/subscriber_filter.hpp>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp/version.h>

class Clouds : public rclcpp::Node
{
public:
  Clouds() : Node("clouds")
  {
#if RCLCPP_VERSION_GTE(30, 0, 0)
    const point_cloud_transport::TransportHints hint("raw");
    clouds_ = std::make_shared<point_cloud_transport::PointCloudTransport>(*this);
    near_ = clouds_->subscribe(
      "near", rclcpp::SensorDataQoS(rclcpp::KeepLast(10)), std::bind(&Clouds::onNear, this, std::placeholders::_1), {}, &hint);
    far_ = std::make_shared<point_cloud_transport::SubscriberFilter>(*this, "far", "raw", rclcpp::QoS(5));
#elif RCLCPP_VERSION_MAJOR > 27
    old_ = create_subscription<sensor_msgs::msg::PointCloud2>("old", 10, [](sensor_msgs::msg::PointCloud2::ConstSharedPtr) {});
#else
    old_ = create_subscription<sensor_msgs::msg::PointCloud2>("older", 10, [](sensor_msgs::msg::PointCloud2::ConstSharedPtr) {});
#endif
    images_ = std::make_shared<image_transport::ImageTransport>(*this);
    picture_ = images_->subscribe("picture", 3, std::bind(&Clouds::onPicture, this, std::placeholders::_1), {}, nullptr);
  }

private:
  void onNear(const sensor_msgs::msg::PointCloud2::ConstSharedPtr &) {}
  void onPicture(const sensor_msgs::msg::Image::ConstSharedPtr &) {}

  std::shared_ptr<point_cloud_transport::PointCloudTransport> clouds_;
  point_cloud_transport::Subscriber near_;
  std::shared_ptr<point_cloud_transport::SubscriberFilter> far_;
  rclcpp::Subscription<sensor_msgs::msg::PointCloud2>::SharedPtr old_;
  std::shared_ptr<image_transport::ImageTransport> images_;
  image_transport::Subscriber picture_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Clouds>());
}
