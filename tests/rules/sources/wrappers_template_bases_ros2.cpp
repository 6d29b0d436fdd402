// A class template hands the name on to its base, an instance of another template: the ports are those of the objects that are made.
//
// expect: service_client gate/open std_srvs/Trigger
// expect: service_client gate/shut std_srvs/SetBool
// expect: publisher count std_msgs/Int32
// expect-only: service_client publisher
#include <map>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/int32.hpp>
#include <std_srvs/srv/set_bool.hpp>
#include <std_srvs/srv/trigger.hpp>

template <typename S>
class Caller
{
public:
  Caller(rclcpp::Node * node, std::string name, unsigned patience) : name_(name), patience_(patience)
  {
    client_ = node->create_client<S>(name);
  }

protected:
  std::string name_;
  unsigned patience_;
  typename rclcpp::Client<S>::SharedPtr client_;
};

template <typename S>
class PatientCaller : public Caller<S>
{
public:
  PatientCaller(rclcpp::Node * node, std::string name) : Caller<S>(node, name, 30), tries_(3) {}

private:
  int tries_;
};

namespace line
{
template <typename K, typename M>
class Sender
{
public:
  Sender(rclcpp::Node & node, std::string name) { publisher_ = node.create_publisher<M>(name, 10); }

private:
  std::map<K, M> sent_;
  typename rclcpp::Publisher<M>::SharedPtr publisher_;
};
}  // namespace line

template <typename M>
class NamedSender : public line::Sender<std::vector<std::string>, M>
{
public:
  NamedSender(rclcpp::Node & node, std::string name) : line::Sender<std::vector<std::string>, M>{node, name} {}
};

class Panel : public rclcpp::Node
{
public:
  Panel() : Node("panel")
  {
    open_ = std::make_unique<PatientCaller<std_srvs::srv::Trigger>>(this, "gate/open");
    shut_ = std::make_unique<PatientCaller<std_srvs::srv::SetBool>>(this, "gate/shut");
    count_ = std::make_unique<NamedSender<std_msgs::msg::Int32>>(*this, "count");
  }

private:
  std::unique_ptr<PatientCaller<std_srvs::srv::Trigger>> open_;
  std::unique_ptr<PatientCaller<std_srvs::srv::SetBool>> shut_;
  std::unique_ptr<NamedSender<std_msgs::msg::Int32>> count_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Panel>());
}
