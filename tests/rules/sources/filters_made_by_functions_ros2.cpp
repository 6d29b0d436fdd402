// A filter of messages and what feeds it, both made by std::make_unique in a base class that leaves the callback to others.
//
// expect: publisher out std_msgs/String queue=1
// expect: subscriber scan sensor_msgs/LaserScan queue=5 callback=scanned via=message_filters
// expect-only: subscriber
// expect: reactive scan -> out
#include <functional>
#include <memory>
#include <string>
#include <message_filters/subscriber.h>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <std_msgs/msg/string.hpp>
#include <tf2_ros/buffer.h>
#include <tf2_ros/message_filter.h>

using sensor_msgs::msg::LaserScan;

class Listener : public rclcpp::Node
{
public:
  Listener() : Node("listener") {}

  void start()
  {
    publisher_ = create_publisher<std_msgs::msg::String>("out", 1);
    buffer_ = std::make_unique<tf2_ros::Buffer>(get_clock());
    subscriber_ = std::make_unique<message_filters::Subscriber<LaserScan>>(this, topic_, rmw_qos_profile_sensor_data);
    filter_ = std::make_unique<tf2_ros::MessageFilter<LaserScan>>(*subscriber_, *buffer_, "odom", 1, get_node_logging_interface(), get_node_clock_interface());
    filter_->registerCallback(std::bind(&Listener::scanned, this, std::placeholders::_1));
  }

protected:
  virtual void scanned(LaserScan::ConstSharedPtr scan) = 0;

  rclcpp::Publisher<std_msgs::msg::String>::SharedPtr publisher_;

private:
  std::string topic_{"scan"};
  std::unique_ptr<tf2_ros::Buffer> buffer_;
  std::unique_ptr<message_filters::Subscriber<LaserScan>> subscriber_;
  std::unique_ptr<tf2_ros::MessageFilter<LaserScan>> filter_;
};

class Repeater : public Listener
{
private:
  void scanned(LaserScan::ConstSharedPtr) override
  {
    publisher_->publish(std_msgs::msg::String());
  }
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Repeater>();
  node->start();
  rclcpp::spin(node);
}
