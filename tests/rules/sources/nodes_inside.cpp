// A node that another node makes inside of its own may be in another namespace; what helpers make on a node at hand is that node's.
// expect: of_inner_node([_, "publisher", "costmap"])
// expect: Count = count : { of_inner_node([_, Kind, _]), Kind != "service_server" }, Count = 2
// expect: of_inner_node([_, "publisher", "helped"])
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>

using Text = std_msgs::msg::String;

class Helper {
public:
  explicit Helper(rclcpp::Node * node, const std::string & name) { pub_ = node->create_publisher<Text>(name, 1); }

private:
  rclcpp::Publisher<Text>::SharedPtr pub_;
};

class OwnHelper {
public:
  explicit OwnHelper(rclcpp::Node * node) { pub_ = node->create_publisher<Text>("own", 1); }

private:
  rclcpp::Publisher<Text>::SharedPtr pub_;
};

class Costmap : public rclcpp::Node {
public:
  Costmap(const std::string & name, const std::string & space) : Node(name, space) {
    pub_ = create_publisher<Text>("costmap", 1);
    helper_ = std::make_unique<Helper>(this, "helped");
    clock_ = create_publisher<Text>("/clock", 1);
  }

private:
  rclcpp::Publisher<Text>::SharedPtr pub_, clock_;
  std::unique_ptr<Helper> helper_;
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
    helper_ = std::make_unique<OwnHelper>(this);
  }

private:
  std::shared_ptr<Costmap> costmap_;
  std::unique_ptr<OwnHelper> helper_;
  rclcpp::Publisher<Text>::SharedPtr own_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Planner>());
}
