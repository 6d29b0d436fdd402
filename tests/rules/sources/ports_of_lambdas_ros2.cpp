// The callback that is told of a port is what a lambda calls with what it is given; a lambda that keeps what that gives is told itself. What is left to a library: the depth of a filter's
// subscriber, the message that a name of a library stands for.
//
// expect: subscriber image callback=Viewer::show
// expect: subscriber limit callback=Viewer::scale
// expect: service_server add callback="lambda in Viewer::Viewer"
// expect: subscriber points queue=10
// expect: publisher times autoware_internal_debug_msgs/ProcessingTimeTree
#include <autoware_utils_debug/time_keeper.hpp>
#include <example_interfaces/srv/add_two_ints.hpp>
#include <message_filters/subscriber.h>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/image.hpp>
#include <sensor_msgs/msg/point_cloud2.hpp>
#include <std_msgs/msg/float64.hpp>

class Viewer : public rclcpp::Node
{
public:
  using Add = example_interfaces::srv::AddTwoInts;

  Viewer() : Node("viewer"), points_(this, "points")
  {
    image_ = create_subscription<sensor_msgs::msg::Image>("image", 1, [this](sensor_msgs::msg::Image::ConstSharedPtr image) { show(image, true); });
    limit_ = create_subscription<std_msgs::msg::Float64>("limit", 1, [this](std_msgs::msg::Float64::ConstSharedPtr limit) { scale(limit->data); });
    add_ = create_service<Add>("add", [this](Add::Request::SharedPtr request, Add::Response::SharedPtr response) { response->sum = added(request); });
    times_ = create_publisher<autoware_utils_debug::ProcessingTimeDetail>("times", 1);
    keeper_ = std::make_shared<autoware_utils_debug::TimeKeeper>(times_);
  }

private:
  void show(sensor_msgs::msg::Image::ConstSharedPtr, bool) {}
  void scale(double factor) { factor_ = factor; }
  int64_t added(Add::Request::SharedPtr request) { return request->a + request->b; }

  double factor_ = 1.0;
  message_filters::Subscriber<sensor_msgs::msg::PointCloud2> points_;
  rclcpp::Subscription<sensor_msgs::msg::Image>::SharedPtr image_;
  rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr limit_;
  rclcpp::Service<Add>::SharedPtr add_;
  rclcpp::Publisher<autoware_utils_debug::ProcessingTimeDetail>::SharedPtr times_;
  std::shared_ptr<autoware_utils_debug::TimeKeeper> keeper_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Viewer>());
}
