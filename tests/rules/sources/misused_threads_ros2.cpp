// Threads, filters, buffers and times that are used wrongly, each beside what is right.
//
// expect: 1 = count : { misused(_, "thread not joined", "worker") }
// expect: 1 = count : { misused(_, "thread not joined", _) }
// expect: 1 = count : { misused(_, "spun twice", _) }
// expect: 1 = count : { misused(_, "shut down", _) }
// expect: 1 = count : { misused(_, "filter alone", _) }
// expect: 1 = count : { misused(_, "buffer alone", _) }
// expect: 1 = count : { misused(_, "lookup of now", _) }
// expect: 1 = count : { misused(_, "two clocks", _) }
// expect: 1 = count : { misused(_, "value of another type", _) }
// expect: misused(_, "value of another type", "rate as integer, and it is declared as float")
// expect-not: misused(_, "no thread", _); misused(_, "object for value", _)
#include <memory>
#include <thread>
#include <message_filters/subscriber.h>
#include <message_filters/sync_policies/approximate_time.h>
#include <message_filters/synchronizer.h>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/image.hpp>
#include <tf2_ros/buffer.h>

using Image = sensor_msgs::msg::Image;
using Policy = message_filters::sync_policies::ApproximateTime<Image, Image>;

class Look : public rclcpp::Node {
public:
  Look() : Node("look") {
    buffer_ = std::make_shared<tf2_ros::Buffer>(get_clock());
    declare_parameter("rate", 2.0);
    declare_parameter("address", rclcpp::PARAMETER_STRING);
    std::string address = get_parameter("address").as_string();
    int rate = get_parameter("rate").as_int();
    double right = get_parameter("rate").as_double();
    declare_parameter<double>("scale", 1);
    right *= get_parameter("scale").as_double();
    if (get_parameter("address", address) && get_parameter("scale", right)) {
      RCLCPP_INFO(get_logger(), "set");
    }
    if (get_parameter("scale", right)) {
      RCLCPP_INFO(get_logger(), "set");
    }
    sync_ = std::make_shared<message_filters::Synchronizer<Policy>>(Policy(10), left_, right_);
    timer_ = create_wall_timer(std::chrono::seconds(1), [this]() { tick(); });
    begun_ = now();
    RCLCPP_INFO(get_logger(), "%d %f %s", rate, right, address.c_str());
  }

private:
  void tick() {
    auto wrong = now() - last_;
    auto good = now() - right_time_;
    auto also_good = now() - begun_;
    last_ = now();
    guarded();
    buffer_->lookupTransform("odom", "base_link", now());
    buffer_->lookupTransform("odom", "base_link", tf2::TimePointZero);
    RCLCPP_INFO(get_logger(), "%f %f %f", wrong.seconds(), good.seconds(), also_good.seconds());
  }
  void guarded() {
    if (!started_) {
      first_ = now();
      started_ = true;
    }
    auto age = now() - first_;
    RCLCPP_INFO(get_logger(), "%f", age.seconds());
  }
  std::shared_ptr<tf2_ros::Buffer> buffer_;
  message_filters::Subscriber<Image> left_;
  message_filters::Subscriber<Image> right_;
  std::shared_ptr<message_filters::Synchronizer<Policy>> sync_;
  rclcpp::TimerBase::SharedPtr timer_;
  rclcpp::Time last_{0, 0};
  rclcpp::Time first_{0, 0};
  rclcpp::Time begun_{0, 0};
  rclcpp::Time right_time_{0, 0, RCL_ROS_TIME};
  bool started_ = false;
};

void work() {
  std::thread worker([]() {});
  std::thread joined([]() {});
  std::thread none;
  joined.join();
}

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  work();
  auto node = std::make_shared<Look>();
  std::thread thread([node]() { rclcpp::spin(node); });
  rclcpp::shutdown();
  rclcpp::spin(node);
  thread.join();
  rclcpp::shutdown();
}
