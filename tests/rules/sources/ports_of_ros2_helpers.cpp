// Ports of a node of ROS 2 that helpers of the workspace make: filters that a function makes and gives back, with a class that takes over the
// constructors of the library's, subscribers that poll by a policy; and parameters that the node sets itself.
//
// expect: subscriber scan sensor_msgs/LaserScan
// expect: subscriber points sensor_msgs/PointCloud2
// expect: subscriber odometry nav_msgs/Odometry
// expect: subscriber limit std_msgs/Float64
// expect: subscriber battery via=polling
// expect-only: subscriber
// expect: reactive scan -> seen must
// expect: reactive points -> near must
// expect-only: reactive * -> *
// expect: param speed = 1.5 op=write
// expect: param gain = 2 op=write
// expect-only: param * op=write
#include <autoware_utils_rclcpp/polling_subscriber.hpp>
#include <message_filters/cache.h>
#include <message_filters/subscriber.h>
#include <nav_msgs/msg/odometry.hpp>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <sensor_msgs/msg/point_cloud2.hpp>
#include <std_msgs/msg/empty.hpp>
#include <std_msgs/msg/float64.hpp>
#include <tf2_ros/buffer.h>
#include <tf2_ros/message_filter.h>

using LaserScan = sensor_msgs::msg::LaserScan;
using PointCloud2 = sensor_msgs::msg::PointCloud2;

template <typename MessageT>
struct Filter : tf2_ros::MessageFilter<MessageT>
{
  using tf2_ros::MessageFilter<MessageT>::MessageFilter;
  using SharedPtr = std::shared_ptr<Filter<MessageT>>;
};

template <typename MessageT, typename SubscriberT, typename NodeT>
inline typename Filter<MessageT>::SharedPtr create_filter(SubscriberT & sub, tf2_ros::Buffer & buffer, const NodeT & node)
{
  return std::make_shared<Filter<MessageT>>(sub, buffer, "map", 10, node->get_node_logging_interface(), node->get_node_clock_interface());
}

template <typename MessageT>
struct Latest {};
template <typename MessageT>
struct Newest {};

template <typename MessageT, template <typename> class Policy = Latest>
class Poller
{
public:
  Poller(rclcpp::Node * node, const std::string & topic, const rclcpp::QoS & qos)
  : subscription_(node->create_subscription<MessageT>(topic, qos, [](const MessageT &) {})) {}

private:
  typename rclcpp::Subscription<MessageT>::SharedPtr subscription_;
};

template <typename MessageT, template <typename> class Policy = Latest>
std::shared_ptr<Poller<MessageT, Policy>> create_poller(rclcpp::Node * node, const std::string & topic, const rclcpp::QoS & qos = rclcpp::QoS{1})
{
  return std::make_shared<Poller<MessageT, Policy>>(node, topic, qos);
}

template <typename MessageT, template <typename> class Policy = autoware_utils_rclcpp::polling_policy::Latest>
class Taker
{
public:
  Taker(rclcpp::Node * node, const std::string & topic)
  : subscriber_(autoware_utils_rclcpp::InterProcessPollingSubscriber<MessageT, Policy>::create_subscription(node, topic, rclcpp::QoS{1})) {}

private:
  typename autoware_utils_rclcpp::InterProcessPollingSubscriber<MessageT, Policy>::SharedPtr subscriber_;
};

class Robot : public rclcpp::Node
{
public:
  Robot() : Node("robot"), buffer_(get_clock())
  {
    seen_pub_ = create_publisher<std_msgs::msg::Empty>("seen", 1);
    near_pub_ = create_publisher<std_msgs::msg::Empty>("near", 1);
    scan_sub_ = std::make_unique<message_filters::Subscriber<LaserScan>>(this, "scan", rmw_qos_profile_sensor_data);
    scan_filter_ = create_filter<LaserScan>(*scan_sub_, buffer_, this);
    scan_filter_->registerCallback(std::bind(&Robot::onScan, this, std::placeholders::_1));
    points_sub_.subscribe(this, "points", rmw_qos_profile_sensor_data);
    points_cache_ = std::make_shared<message_filters::Cache<PointCloud2>>(points_sub_, 10);
    points_cache_->registerCallback(std::bind(&Robot::onPoints, this, std::placeholders::_1));
    set_parameter(rclcpp::Parameter("speed", 1.5));
    set_parameter({"gain", 2});
  }

private:
  void onScan(const LaserScan::ConstSharedPtr &) { seen_pub_->publish(std_msgs::msg::Empty()); }
  void onPoints(const PointCloud2::ConstSharedPtr &) { near_pub_->publish(std_msgs::msg::Empty()); }

  tf2_ros::Buffer buffer_;
  rclcpp::Publisher<std_msgs::msg::Empty>::SharedPtr seen_pub_, near_pub_;
  std::unique_ptr<message_filters::Subscriber<LaserScan>> scan_sub_;
  Filter<LaserScan>::SharedPtr scan_filter_;
  message_filters::Subscriber<PointCloud2> points_sub_;
  std::shared_ptr<message_filters::Cache<PointCloud2>> points_cache_;
  std::shared_ptr<Poller<nav_msgs::msg::Odometry>> odometry_ = create_poller<nav_msgs::msg::Odometry>(this, "odometry");
  std::shared_ptr<Poller<std_msgs::msg::Float64, Newest>> limit_ = create_poller<std_msgs::msg::Float64, Newest>(this, "limit");
  std::shared_ptr<Taker<std_msgs::msg::Float64>> battery_ = std::make_shared<Taker<std_msgs::msg::Float64>>(this, "battery");
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
}
