// The type of what a port carries is told where a function of the workspace is called, through class templates and functions that hand it on.
//
// expect: subscriber odom nav_msgs/Odometry via=polling
// expect: subscriber odom2 nav_msgs/Odometry via=polling
// expect: subscriber odom3 nav_msgs/Odometry via=polling latched
// expect: publisher odom4 nav_msgs/Odometry
#include <autoware_utils_rclcpp/polling_subscriber.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <rclcpp/rclcpp.hpp>

using nav_msgs::msg::Odometry;
namespace polling = autoware_utils_rclcpp;

template <typename M, template <typename> class Policy = polling::polling_policy::Latest>
class Latest
{
public:
  using SharedPtr = std::shared_ptr<Latest<M, Policy>>;
  virtual ~Latest() = default;
};

template <typename M, template <typename> class Policy = polling::polling_policy::Latest>
class Polled : public Latest<M, Policy>
{
public:
  explicit Polled(rclcpp::Node * node, const std::string & topic, const rclcpp::QoS & qos)
  : subscriber_(polling::InterProcessPollingSubscriber<M, Policy>::create_subscription(node, topic, qos)) {}

private:
  typename polling::InterProcessPollingSubscriber<M, Policy>::SharedPtr subscriber_;
};

template <typename M, template <typename> class Policy = polling::polling_policy::Latest>
typename Latest<M, Policy>::SharedPtr latest(rclcpp::Node * node, const std::string & topic, const rclcpp::QoS & qos = rclcpp::QoS{1})
{
  return std::make_shared<Polled<M, Policy>>(node, topic, qos);
}

template <typename M>
typename rclcpp::Publisher<M>::SharedPtr publisher(rclcpp::Node * node, const std::string & topic)
{
  return node->create_publisher<M>(topic, 1);
}

class Base : public rclcpp::Node
{
public:
  Base() : Node("base") { odom2_ = latest<Odometry>(this, "odom2"); }

private:
  Latest<Odometry>::SharedPtr odom_ = latest<Odometry>(this, "odom");
  Latest<Odometry>::SharedPtr odom2_;
  Latest<Odometry, polling::polling_policy::Newest>::SharedPtr odom3_ =
    latest<Odometry, polling::polling_policy::Newest>(this, "odom3", rclcpp::QoS{1}.transient_local());
  rclcpp::Publisher<Odometry>::SharedPtr odom4_ = publisher<Odometry>(this, "odom4");
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Base>());
}
