// Calls without arguments in a macro, all parts of which lie in one place; names that the node resolves; a name that stays empty if a stream has none.
//
// expect: subscriber scan queue=7
// expect: subscriber points
// expect: subscriber ?
// expect: service_server reset
// expect-only: subscriber
#include <fstream>
#include <rclcpp/rclcpp.hpp>
#include <message_filters/subscriber.h>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <std_srvs/srv/empty.hpp>

#define QUALITY(depth) rclcpp::QoS(depth).best_effort().get_rmw_qos_profile()

class Reader : public rclcpp::Node
{
public:
  Reader() : Node("reader")
  {
    using sensor_msgs::msg::LaserScan;
    scan_.subscribe(this, "scan", QUALITY(7));
    points_ = create_subscription<LaserScan>(get_node_topics_interface()->resolve_topic_name("points"), 1, [](LaserScan::SharedPtr) {});
    std::string reset = this->get_node_services_interface()->resolve_service_name("reset");
    reset_ = create_service<std_srvs::srv::Empty>(reset, [](std_srvs::srv::Empty::Request::SharedPtr, std_srvs::srv::Empty::Response::SharedPtr) {});

    std::string other;
    std::ifstream file("names");
    if (file.good())
      file >> other;
    other_ = create_sub_node("sub")->create_subscription<LaserScan>(other, 1, [](LaserScan::SharedPtr) {});
  }

private:
  message_filters::Subscriber<sensor_msgs::msg::LaserScan> scan_;
  rclcpp::Subscription<sensor_msgs::msg::LaserScan>::SharedPtr points_, other_;
  rclcpp::Service<std_srvs::srv::Empty>::SharedPtr reset_;
};

int main(int argc, char** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Reader>());
}
