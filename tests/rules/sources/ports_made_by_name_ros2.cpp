// A helper of a library makes a publisher for each name that it is given a message for, in the namespace of the object.
//
// expect: publisher ~debug/cyclic_time_ms std_msgs/Float64 queue=1
// expect: publisher filter/cloud sensor_msgs/PointCloud2 queue=1
// expect: publisher ~times diagnostic_msgs/DiagnosticStatus queue=1
// expect: subscriber points sensor_msgs/PointCloud2 queue=1
// expect: reactive points -> ~debug/cyclic_time_ms must
// expect: reactive points -> filter/cloud must
// expect: reactive points -> ~times must
#include <autoware_utils_debug/debug_publisher.hpp>
#include <autoware_utils_debug/processing_time_publisher.hpp>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/point_cloud2.hpp>
#include <std_msgs/msg/float64.hpp>

class Filter : public rclcpp::Node
{
public:
  Filter() : Node("filter"), times_(this, "~/times")
  {
    debug_ = std::make_unique<autoware_utils_debug::DebugPublisher>(this, "~/debug");
    clouds_ = std::make_unique<autoware_utils_debug::DebugPublisher>(this, this->get_name());
    points_ = create_subscription<sensor_msgs::msg::PointCloud2>("points", 1, std::bind(&Filter::onPoints, this, std::placeholders::_1));
  }

private:
  void onPoints(sensor_msgs::msg::PointCloud2::ConstSharedPtr points)
  {
    debug_->publish<std_msgs::msg::Float64>("cyclic_time_ms", 1.0);
    const sensor_msgs::msg::PointCloud2 copy = *points;
    clouds_->publish("cloud", copy);
    times_.publish({{"all", 1.0}});
  }

  std::unique_ptr<autoware_utils_debug::DebugPublisher> debug_, clouds_;
  autoware_utils_debug::ProcessingTimePublisher times_;
  rclcpp::Subscription<sensor_msgs::msg::PointCloud2>::SharedPtr points_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Filter>());
}
