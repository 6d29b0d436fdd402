// Interfaces whose absent headers do not tell which letters of their names are capitals: the source does.
//
// expect: service_client from_ll far_msgs/FromLL
// expect: publisher imu far_msgs/IMUState
// expect: publisher mode far_msgs/OnMode
// expect: subscriber gps far_msgs/GPS
// expect: reactive gps -> from_ll
#include <far_msgs/msg/gps.hpp>
#include <far_msgs/msg/imu_state.hpp>
#include <far_msgs/msg/on_mode.hpp>
#include <far_msgs/srv/from_ll.hpp>
#include <rclcpp/rclcpp.hpp>

class Localizer : public rclcpp::Node
{
public:
  Localizer() : Node("localizer")
  {
    imu_ = create_publisher<far_msgs::msg::IMUState>("imu", 1);
    mode_ = create_publisher<far_msgs::msg::OnMode>("mode", 1);
    client_ = create_client<far_msgs::srv::FromLL>("from_ll");
    gps_ = create_subscription<far_msgs::msg::GPS>("gps", 1, [this](const far_msgs::msg::GPS::ConstSharedPtr gps) {
      auto request = std::make_shared<far_msgs::srv::FromLL::Request>();
      request->point = gps->point;
      client_->async_send_request(request);
    });
  }

private:
  rclcpp::Publisher<far_msgs::msg::IMUState>::SharedPtr imu_;
  rclcpp::Publisher<far_msgs::msg::OnMode>::SharedPtr mode_;
  rclcpp::Client<far_msgs::srv::FromLL>::SharedPtr client_;
  rclcpp::Subscription<far_msgs::msg::GPS>::SharedPtr gps_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Localizer>());
}
