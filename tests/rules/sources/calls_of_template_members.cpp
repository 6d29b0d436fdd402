// Ports that objects make which a constructor of a template has for members.
//
// expect: service_client ~arm/change_state std_srvs/Trigger
// expect-not: publisher /never
// expect: reactive /in -> ~arm/change_state
// expect: 6 = count : { call_role(_, _, _) }
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/empty.hpp>
#include <std_srvs/srv/trigger.hpp>
#include <string>

template <class Service>
class Client {
public:
  template <class NodeT>
  Client(const std::string & name, const NodeT & node, bool own = false) : own_(own) {
    client_ = node->template create_client<Service>(name);
  }
  void ask() { client_->async_send_request(std::make_shared<typename Service::Request>()); }

private:
  bool own_;
  typename rclcpp::Client<Service>::SharedPtr client_;
};

class Life {
public:
  template <class NodeT>
  Life(const std::string & name, NodeT node) : change_(name + "/change_state", node, true) {}
  void change() { change_.ask(); }

private:
  Client<std_srvs::srv::Trigger> change_;
};

class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") {
    life_ = std::make_shared<Life>("~/arm", this);
    sub_ = create_subscription<std_msgs::msg::Empty>("/in", 1, [this](const std_msgs::msg::Empty &) { life_->change(); });
  }

  // nobody calls it
  void later(bool now = true) { other_ = create_publisher<std_msgs::msg::Empty>("/never", 1); }

private:
  rclcpp::Publisher<std_msgs::msg::Empty>::SharedPtr other_;
  std::shared_ptr<Life> life_;
  rclcpp::Subscription<std_msgs::msg::Empty>::SharedPtr sub_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
}
