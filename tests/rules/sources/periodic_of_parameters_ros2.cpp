// How often a loop runs whose frequency is a parameter, held by a variable that begins otherwise.
//
// expect: periodic map 5 Hz mechanism=rate hz_from_param=map_frequency
// expect: periodic plan 2 Hz mechanism=timer hz_from_param=plan_frequency
#include <chrono>
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/empty.hpp>
#include <thread>

class Mapper : public rclcpp::Node
{
public:
  Mapper() : Node("mapper")
  {
    map_ = create_publisher<std_msgs::msg::Empty>("map", 1);
    plan_ = create_publisher<std_msgs::msg::Empty>("plan", 1);
  }
  void configure()
  {
    map_frequency_ = declare_parameter("map_frequency", 5.0);
    plan_frequency_ = declare_parameter("plan_frequency", 2.0);
  }
  void start()
  {
    thread_ = std::make_unique<std::thread>(std::bind(&Mapper::loop, this, map_frequency_));
    timer_ = create_wall_timer(std::chrono::duration<double>(1.0 / plan_frequency_), [this]() { plan_->publish(std_msgs::msg::Empty()); });
  }

private:
  void loop(double frequency)
  {
    rclcpp::Rate rate(frequency);
    while (rclcpp::ok()) {
      map_->publish(std_msgs::msg::Empty());
      rate.sleep();
    }
  }
  double map_frequency_{0};
  double plan_frequency_ = 1.0;
  std::unique_ptr<std::thread> thread_;
  rclcpp::TimerBase::SharedPtr timer_;
  rclcpp::Publisher<std_msgs::msg::Empty>::SharedPtr map_, plan_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<Mapper>();
  node->configure();
  node->start();
  rclcpp::spin(node);
}
