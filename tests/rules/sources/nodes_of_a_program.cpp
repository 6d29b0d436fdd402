// A program of ROS 2 that makes three nodes: two are objects of classes, one gets its ports in main. A function that main calls serves all of them.
//
// expect: Count = count : { made_node(_, _) }, Count = 3
// expect: made_node(_, "talker"), made_node(_, "listener"), made_node(_, "plain")
// expect: takes_given_name(_, "talker"), takes_given_name(_, "listener"), takes_given_name(_, "plain")
// expect: port([Site, "publisher", "chatter"]), node_element("talker", Site), !node_element("listener", Site), !node_element("plain", Site)
// expect: port([Site, "subscriber", "chatter"]), node_element("listener", Site), !node_element("talker", Site)
// expect: port([Site, "publisher", "status"]), node_element("plain", Site), !node_element("talker", Site), !node_element("listener", Site)
// expect: port([Site, "publisher", "shared"]), !node_element(_, Site)
// expect: state_variable(V), variable_name(V, "silent_"), node_element("talker", V), !node_element("listener", V)
// expect: function_name(F, "Listener::heard"), node_element("listener", F), !node_element("talker", F)
#include <chrono>
#include <memory>
#include <string>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>

class Talker : public rclcpp::Node
{
public:
  explicit Talker(const std::string & name) : rclcpp::Node(name)
  {
    publisher_ = create_publisher<std_msgs::msg::Bool>("chatter", 10);
    timer_ = create_wall_timer(std::chrono::seconds(1), [this]() { tick(); });
  }

private:
  void tick()
  {
    if (!silent_) {
      publisher_->publish(std_msgs::msg::Bool());
    }
    silent_ = !silent_;
  }

  bool silent_ = false;
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr publisher_;
  rclcpp::TimerBase::SharedPtr timer_;
};

class Listener : public rclcpp::Node
{
public:
  Listener() : Node("listener")
  {
    subscription_ = create_subscription<std_msgs::msg::Bool>("chatter", 10, std::bind(&Listener::heard, this, std::placeholders::_1));
    // a node within a node is not the program's
    inner_ = rclcpp::Node::make_shared("inner");
  }

private:
  void heard(const std_msgs::msg::Bool::SharedPtr) {}

  rclcpp::Subscription<std_msgs::msg::Bool>::SharedPtr subscription_;
  rclcpp::Node::SharedPtr inner_;
};

void serve(const rclcpp::Node::SharedPtr & node)
{
  static auto shared = node->create_publisher<std_msgs::msg::Bool>("shared", 1);
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto talker = std::make_shared<Talker>("talker");
  auto listener = std::make_shared<Listener>();
  auto plain = rclcpp::Node::make_shared("plain");
  auto status = plain->create_publisher<std_msgs::msg::Bool>("status", 1);
  serve(plain);
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(talker);
  executor.add_node(listener);
  executor.add_node(plain);
  executor.spin();
  return 0;
}
