// Servers of one class do in a thread what each was given.
// expect-only: reactive * -> *
// expect: N = count : { value_from(_, _, _) }, N = 3, 2 = count : { port_handler(_, _) }, 3 = count : { _runs_in_main(_) }
// expect-not: call_unfit(_, _); _enters_all(_, _); result_value(_, _)
// expect: 6 = count : { as_given(_, _, _) }, 8 = count : { constant_text(_, _) }, 2 = count : { given_callback(_, _) }
#include <functional>
#include <future>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_action/rclcpp_action.hpp>
#include <nav2_msgs/action/navigate_to_pose.hpp>
#include <std_msgs/msg/string.hpp>

using Drive = nav2_msgs::action::NavigateToPose;
using Text = std_msgs::msg::String;

template <class Action>
class Server {
public:
  Server(rclcpp::Node * node, const std::string & name, std::function<void()> work) : work_(work) {
    server_ = rclcpp_action::create_server<Action>(
      node, name, nullptr, nullptr, std::bind(&Server::accepted, this, std::placeholders::_1));
  }
  void accepted(const std::shared_ptr<rclcpp_action::ServerGoalHandle<Action>>) {
    if (done_.valid()) told_ = 1;
    done_ = std::async(std::launch::async, [this]() { work_(); });
  }

private:
  int told_;
  std::function<void()> work_;
  std::future<void> done_;
  typename rclcpp_action::Server<Action>::SharedPtr server_;
};
// expect-not: state

class Robot : public rclcpp::Node {
public:
  Robot() : Node("robot") {
    dock_ = std::make_shared<Server<Drive>>(this, "dock", std::bind(&Robot::dock, this));
    leave_ = std::make_shared<Server<Drive>>(this, "leave", std::bind(&Robot::leave, this));
    light_ = create_publisher<Text>("light", 1);
    sound_ = create_publisher<Text>("sound", 1);
  }

private:
  void dock() { light_->publish(Text()); }  // expect: reactive dock -> light
  void leave() { sound_->publish(Text()); }  // expect: reactive leave -> sound

  std::shared_ptr<Server<Drive>> dock_, leave_;
  rclcpp::Publisher<Text>::SharedPtr light_, sound_;
};

int main(int argc, char ** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Robot>());
}
