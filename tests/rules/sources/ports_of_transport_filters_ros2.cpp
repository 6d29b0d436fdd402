// Subscribers that feed filters, of ROS 2: the quality of service is the third argument, or the fourth behind the name of a transport.
//
// expect: subscriber left sensor_msgs/Image queue=5 via=image_transport
// expect: subscriber right sensor_msgs/Image queue=3 callback=Eyes::onImage via=image_transport
// expect: subscriber depth sensor_msgs/PointCloud2 queue=7 via=point_cloud_transport
// expect: subscriber plain sensor_msgs/Image queue= via=image_transport
// expect: subscriber scan sensor_msgs/LaserScan queue=5 via=message_filters
// expect: subscriber narrow sensor_msgs/LaserScan queue=2 via=message_filters
// expect: subscriber wide sensor_msgs/LaserScan queue=1 via=message_filters
// expect: subscriber far sensor_msgs/LaserScan queue=10 via=message_filters
// expect: subscriber old sensor_msgs/LaserScan queue=6 via=message_filters
// expect-only: subscriber
// expect: port_quality([_, "subscriber", "left"], "reliability", "best_effort"), port_quality([_, "subscriber", "scan"], "reliability", "best_effort")
// expect: port_quality([_, "subscriber", "far"], "reliability", "reliable"), port_quality([_, "subscriber", "far"], "durability", "volatile")
// expect: port_quality([_, "subscriber", "wide"], "reliability", "best_effort"), port_quality([_, "subscriber", "narrow"], "reliability", "reliable")
#include <image_transport/image_transport.hpp>
#include <image_transport/subscriber_filter.hpp>
#include <message_filters/subscriber.hpp>
#include <point_cloud_transport/subscriber_filter.hpp>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>

using Scans = message_filters::Subscriber<sensor_msgs::msg::LaserScan>;

class Eyes : public rclcpp::Node
{
public:
  Eyes() : Node("eyes"), left_(this, "left", "raw", rmw_qos_profile_sensor_data), scan_(this, "scan", rmw_qos_profile_sensor_data)
  {
    image_transport::TransportHints hints(this);
    right_.subscribe(this, "right", hints.getTransport(), rclcpp::QoS(3).get_rmw_qos_profile());
    right_.registerCallback(std::bind(&Eyes::onImage, this, std::placeholders::_1));
    const std::string transport = "raw";
    depth_ = std::make_shared<point_cloud_transport::SubscriberFilter>(*this, "depth", transport, rclcpp::QoS(7), rclcpp::SubscriptionOptions());
    plain_ = std::make_shared<image_transport::SubscriberFilter>(this, "plain", transport);
    narrow_.subscribe(this, "narrow", rclcpp::QoS(2), rclcpp::SubscriptionOptions());
    wide_ = std::make_shared<Scans>(this, "wide", rclcpp::SensorDataQoS().keep_last(1));
    far_ = std::make_shared<Scans>(this, "far");
    auto profile = rmw_qos_profile_default;
    profile.depth = 6;
    old_.subscribe(this, "old", profile);
  }

private:
  void onImage(const sensor_msgs::msg::Image::ConstSharedPtr &) {}

  image_transport::SubscriberFilter left_;
  image_transport::SubscriberFilter right_;
  std::shared_ptr<point_cloud_transport::SubscriberFilter> depth_;
  std::shared_ptr<image_transport::SubscriberFilter> plain_;
  Scans scan_;
  Scans narrow_;
  std::shared_ptr<Scans> wide_;
  std::shared_ptr<Scans> far_;
  Scans old_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Eyes>());
}
