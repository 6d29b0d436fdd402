// The cabin: it goes to the floor that is asked for, unless something heavy is in it.
#include <chrono>
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/register_node_macro.hpp"
#include "std_msgs/msg/float64.hpp"
#include "std_msgs/msg/int32.hpp"
#include "std_srvs/srv/trigger.hpp"

using namespace std::chrono_literals;

namespace elevator
{
enum class Motion { IDLE, MOVING, OVERLOADED };

class Cabin : public rclcpp::Node
{
public:
  explicit Cabin(const rclcpp::NodeOptions & options) : Node("cabin", options)
  {
    max_load_ = declare_parameter("max_load", 400.0);
    floor_pub_ = create_publisher<std_msgs::msg::Int32>("floor", rclcpp::QoS(1).transient_local());
    call_sub_ = create_subscription<std_msgs::msg::Int32>("call", 5, [this](std_msgs::msg::Int32::ConstSharedPtr call) { onCall(*call); });
    load_sub_ = create_subscription<std_msgs::msg::Float64>("load", rclcpp::SensorDataQoS(), std::bind(&Cabin::onLoad, this, std::placeholders::_1));
    stop_srv_ = create_service<std_srvs::srv::Trigger>("~/stop", std::bind(&Cabin::onStop, this, std::placeholders::_1, std::placeholders::_2));
    timer_ = create_wall_timer(500ms, [this]() { step(); });
  }

private:
  void onCall(const std_msgs::msg::Int32 & call)
  {
    if (motion_ == Motion::IDLE) {
      target_ = call.data;
      motion_ = Motion::MOVING;
    }
  }

  void onLoad(const std_msgs::msg::Float64::SharedPtr load)
  {
    if (load->data > max_load_) {
      motion_ = Motion::OVERLOADED;
    } else if (motion_ == Motion::OVERLOADED) {
      motion_ = Motion::IDLE;
    }
  }

  void onStop(const std_srvs::srv::Trigger::Request::SharedPtr, std_srvs::srv::Trigger::Response::SharedPtr response)
  {
    motion_ = Motion::IDLE;
    response->success = true;
  }

  void step()
  {
    if (motion_ != Motion::MOVING) {
      return;
    }
    floor_ += floor_ < target_ ? 1 : -1;
    std_msgs::msg::Int32 floor;
    floor.data = floor_;
    floor_pub_->publish(floor);
    if (floor_ == target_) {
      motion_ = Motion::IDLE;
    }
  }

  double max_load_;
  int floor_ = 0;
  int target_ = 0;
  Motion motion_ = Motion::IDLE;
  rclcpp::Publisher<std_msgs::msg::Int32>::SharedPtr floor_pub_;
  rclcpp::Subscription<std_msgs::msg::Int32>::SharedPtr call_sub_;
  rclcpp::Subscription<std_msgs::msg::Float64>::SharedPtr load_sub_;
  rclcpp::Service<std_srvs::srv::Trigger>::SharedPtr stop_srv_;
  rclcpp::TimerBase::SharedPtr timer_;
};
}  // namespace elevator

RCLCPP_COMPONENTS_REGISTER_NODE(elevator::Cabin)
