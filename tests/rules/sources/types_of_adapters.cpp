// Messages of classes of one's own: converted by an adapter that a port, or a specialisation, names.
//
// expect: publisher out std_msgs/String
// expect: subscriber in std_msgs/String
// expect: publisher count std_msgs/Int32
// expect: reactive in -> out must
// expect: 2 = count : { _adapted(_, _) }
#include <memory>
#include <string>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp/type_adapter.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_msgs/msg/int32.hpp>
#include <std_msgs/msg/string.hpp>

struct Count {
  int n;
};

struct Level {
  bool high;
};

template <>
struct rclcpp::TypeAdapter<std::string, std_msgs::msg::String> {
  using is_specialized = std::true_type;
  using custom_type = std::string;
  using ros_message_type = std_msgs::msg::String;
  static void convert_to_ros_message(const custom_type & source, ros_message_type & destination) { destination.data = source; }
  static void convert_to_custom(const ros_message_type & source, custom_type & destination) { destination = source.data; }
};

template <>
struct rclcpp::TypeAdapter<Count, std_msgs::msg::Int32> {
  using is_specialized = std::true_type;
  using custom_type = Count;
  using ros_message_type = std_msgs::msg::Int32;
  static void convert_to_ros_message(const custom_type & source, ros_message_type & destination) { destination.data = source.n; }
  static void convert_to_custom(const ros_message_type & source, custom_type & destination) { destination.n = source.data; }
};

RCLCPP_USING_CUSTOM_TYPE_AS_ROS_MESSAGE_TYPE(Count, std_msgs::msg::Int32);
RCLCPP_USING_CUSTOM_TYPE_AS_ROS_MESSAGE_TYPE(Level, std_msgs::msg::Bool);

class Talker : public rclcpp::Node {
  using Adapted = rclcpp::TypeAdapter<std::string, std_msgs::msg::String>;

public:
  Talker() : Node("talker") {
    out_ = create_publisher<Adapted>("out", 10);
    count_ = create_publisher<Count>("count", 10);
    in_ = create_subscription<Adapted>("in", 10, [this](const std::string & text) { out_->publish(text); });
  }

private:
  rclcpp::Publisher<Adapted>::SharedPtr out_;
  rclcpp::Publisher<Count>::SharedPtr count_;
  rclcpp::Subscription<Adapted>::SharedPtr in_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Talker>());
}
