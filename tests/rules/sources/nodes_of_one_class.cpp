// A program of ROS 2 that makes nodes of shared code: each has the ports that are made for it.
//
// expect: Count = count : { made_node(_, _) }, Count = 4
// expect: port([Site, "publisher", "/fine"]), port_of_other_node("coarse", [Site, "publisher", "/fine"]), !port_of_other_node("fine", [Site, "publisher", "/fine"])
// expect: port([Site, "subscriber", "/mud"]), port_of_other_node("fine", [Site, "subscriber", "/mud"]), !port_of_other_node("coarse", [Site, "subscriber", "/mud"])
// expect: port([Site, "publisher", "/sand"]), node_element("sand", Site), !node_element("fine", Site)
// expect: port([Site, "publisher", "/level"]), port_of_other_node("fine", [Site, "publisher", "/level"]), !port_of_other_node("plain", [Site, "publisher", "/level"])
// expect: port([Site, "publisher", "/status"]), port_of_other_node("plain", [Site, "publisher", "/status"]), !port_of_other_node("fine", [Site, "publisher", "/status"]), !port_of_other_node("coarse", [Site, "publisher", "/status"])
#include <memory>
#include <string>
#include <vector>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>

using std_msgs::msg::Bool;

class Sieve : public rclcpp::Node
{
public:
  Sieve(const std::string & name, const std::string & from, const std::string & to) : rclcpp::Node(name)
  {
    status_ = create_publisher<Bool>("/status", 1);
    publisher_ = create_publisher<Bool>(to, 1);
    subscription_ = create_subscription<Bool>(from, 1, [this](Bool::UniquePtr bit) { publisher_->publish(*bit); });
  }

private:
  rclcpp::Publisher<Bool>::SharedPtr status_;
  rclcpp::Publisher<Bool>::SharedPtr publisher_;
  rclcpp::Subscription<Bool>::SharedPtr subscription_;
};

// its only port is as good as one that the call makes
class Pit : public rclcpp::Node
{
public:
  Pit(const std::string & name, const std::string & topic) : rclcpp::Node(name) { publisher_ = create_publisher<Bool>(topic, 1); }

private:
  rclcpp::Publisher<Bool>::SharedPtr publisher_;
};

std::vector<rclcpp::Publisher<Bool>::SharedPtr> kept;

void publish(const rclcpp::Node::SharedPtr & node, const std::string & topic)
{
  kept.push_back(node->create_publisher<Bool>(topic, 1));
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto plain = rclcpp::Node::make_shared("plain");
  publish(plain, "/level");
  std::vector<rclcpp::Node::SharedPtr> nodes;
  nodes.push_back(std::make_shared<Sieve>("fine", "/sand", "/fine"));
  nodes.push_back(std::make_shared<Sieve>("coarse", "/mud", "/coarse"));
  nodes.emplace_back(std::make_shared<Pit>("sand", "/sand"));
  nodes.push_back(plain);
  rclcpp::executors::SingleThreadedExecutor executor;
  for (auto & node : nodes) {
    executor.add_node(node);
  }
  executor.spin();
  return 0;
}
