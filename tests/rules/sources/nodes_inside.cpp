// A node that another node makes inside of its own may be in another namespace; what helpers make on a node at hand is that node's.
// expect: of_inner_node([_, "publisher", "costmap"])
// expect: Count = count : { of_inner_node([_, Kind, _]), Kind != "service_server" }, Count = 1
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>

using Text = std_msgs::msg::String;

class Costmap : public rclcpp::Node {
public:
  Costmap(const std::string & name, const std::string & space) : Node(name, space) {
    pub_ = create_publisher<Text>("costmap", 1);
    clock_ = create_publisher<Text>("/clock", 1);
  }

private:
  rclcpp::Publisher<Text>::SharedPtr pub_, clock_;
};

class Base : public rclcpp::Node {
public:
  Base() : Node("planner") { base_ = create_publisher<Text>("base", 1); }

private:
  rclcpp::Publisher<Text>::SharedPtr base_;
};

class Planner : public Base {
public:
  Planner() {
    costmap_ = std::make_shared<Costmap>("costmap", "costmap");
    own_ = create_publisher<Text>("plan", 1);
  }

private:
  std::shared_ptr<Costmap> costmap_;
  rclcpp::Publisher<Text>::SharedPtr own_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Planner>());
}
