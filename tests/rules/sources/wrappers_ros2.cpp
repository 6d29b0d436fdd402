// A component of ROS 2 whose ports are made through functions, a class and traits that only hand on what they are given.
//
// expect: service_server reset std_srvs/Trigger
// expect-only: param
// expect: Given = count : { as_given(_, _, _) }, To = count : { given_to_field(_, _, _) }, Typed = count : { _named_by_type(_, _, _) }, Given = 35, To = 3, Typed = 1
// expect: _called_inside(L, V), variable_name(V, "callback_"), 1 = count : { _called_inside(_, _) }
// nothing depends on who calls:
// expect-not: context_call(_, _); entered_from(_, _, _); enters_for_another(_, _, _)
// expect-not: definition(_, _); defined_text(_, _, _, _, _); instantiated(_, _, _, _); _entry_call(_, _, _)
// expect-not: member_of_instance(_, _, _); _instance_argument(_, _, _); _type_by(_, _, _); port_made_through(_, _); handed_on_otherwise(_, _)
// ... and no port or function is given to one that uses it:
// expect-not: given_callback(_, _); sends_through(_, _); _sends_other(_, _, _); _given_to(_, _, _); _slot(_); _other_callee(_, _)
// expect-not: _forwards(_, _); _handled_twice(_); _runs_for(_, _); _makes_several(_); _calls_quality(_, _); text_variable(_); number_variable(_)
// expect-not: _only_reads(_); _not_chosen(_, _)
// expect: 5 = count : { activity(_, _) }, 9 = count : { calls(_, _) }, 12 = count : { chained_type(_, _) }
// expect-not: callback_in_group(_, _, _)
#include <memory>
#include <string>
#include <chrono>
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_components/register_node_macro.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_msgs/msg/int32.hpp>
#include <std_srvs/srv/empty.hpp>
#include <std_srvs/srv/trigger.hpp>

namespace factories
{
template <typename MessageT, typename NodeT>
typename rclcpp::Publisher<MessageT>::SharedPtr publisher(NodeT & node, const std::string & topic)
{
  auto made = rclcpp::create_publisher<MessageT>(node, topic, rclcpp::QoS(3));
  return made;
}

template <typename T, typename NodeT>
T declared(NodeT node, const std::string & name, const T & value)
{
  if (node->has_parameter(name)) {
    return node->get_parameter(name).template get_value<T>();
  }
  return node->declare_parameter(name, rclcpp::ParameterValue(value)).template get<T>();
}

template <typename NodeT>
bool asked(NodeT node, const std::string & name, bool otherwise)
{
  if (!node->has_parameter(name)) {
    return node->template declare_parameter<bool>(name, otherwise);
  }
  return node->get_parameter(name).as_bool();
}
}  // namespace factories

struct Ready
{
  using Message = std_msgs::msg::Bool;
  static constexpr char name[] = "/ready";
};

template <class SpecT>
typename rclcpp::Publisher<typename SpecT::Message>::SharedPtr of_spec(rclcpp::Node * node)
{
  return node->create_publisher<typename SpecT::Message>(SpecT::name, 1);
}

template <class ServiceT>
class Server
{
public:
  template <class NodeT>
  Server(const std::string & name, NodeT node, std::function<void(std::shared_ptr<typename ServiceT::Request>, std::shared_ptr<typename ServiceT::Response>)> callback)
  : callback_(callback)
  {
    server_ = node->template create_service<ServiceT>(name, [this](auto request, auto response) { callback_(request, response); });
  }

private:
  std::function<void(std::shared_ptr<typename ServiceT::Request>, std::shared_ptr<typename ServiceT::Response>)> callback_;
  typename rclcpp::Service<ServiceT>::SharedPtr server_;
};

template <class ServiceT>
class Delegating
{
public:
  using Request = std::shared_ptr<typename ServiceT::Request>;
  using Response = std::shared_ptr<typename ServiceT::Response>;
  using Callback = std::function<void(Request, Response)>;

  Delegating(rclcpp::Node * node, const std::string & name, Callback callback)
  : Delegating(name, node, callback, 1) {}

  Delegating(const std::string & name, rclcpp::Node * node, Callback callback, int)
  : callback_(callback)
  {
    server_ = node->create_service<ServiceT>(name, [this](const Request request, Response response) { this->callback_(request, response); });
  }

private:
  Callback callback_;
  typename rclcpp::Service<ServiceT>::SharedPtr server_;
};

class Counter : public rclcpp::Node
{
public:
  explicit Counter(const rclcpp::NodeOptions & options)
  : Node("counter", options)
  {
    step_ = factories::declared<int>(this, "step", 2);  // expect: param step op=declare
    loud_ = factories::asked(this, "loud", true);  // expect: param loud op=declare
    count_pub_ = factories::publisher<std_msgs::msg::Int32>(*this, "count");  // expect: publisher count std_msgs/Int32 queue=3
    other_pub_ = factories::publisher<std_msgs::msg::Bool>(*this, "~/other");  // expect: publisher ~other std_msgs/Bool queue=3
    ready_pub_ = of_spec<Ready>(this);  // expect: publisher /ready std_msgs/Bool
    level_sub_ = create_subscription<std_msgs::msg::Int32>(  // expect: subscriber level std_msgs/Int32 queue=10 callback=Counter::onLevel
      "level", 10, std::bind(&Counter::onLevel, this, std::placeholders::_1));
    server_ = std::make_shared<Server<std_srvs::srv::Trigger>>("reset", this, [this](auto, auto) { level_ = 0; });
    halt_ = std::make_shared<Delegating<std_srvs::srv::Empty>>(  // expect: service_server halt std_srvs/Empty callback=Counter::onHalt
      this, "halt", std::bind(&Counter::onHalt, this, std::placeholders::_1, std::placeholders::_2));
    timer_ = create_wall_timer(std::chrono::milliseconds(500), [this]() {  // expect: periodic count 2 Hz
      if (level_ > 0) {
        count_pub_->publish(std_msgs::msg::Int32());
      }
    });
    handle_ = add_on_set_parameters_callback([this](const std::vector<rclcpp::Parameter> &) {
      level_ = 1;  // expect: transition Counter::level_ = 1 on parameters
      return rcl_interfaces::msg::SetParametersResult();
    });
  }

private:
  void onLevel(std_msgs::msg::Int32::ConstSharedPtr message)
  {
    level_ = message->data;  // expect: transition Counter::level_ on level
    ready_pub_->publish(std_msgs::msg::Bool());  // expect: reactive level -> /ready must
  }

  void onHalt(std::shared_ptr<std_srvs::srv::Empty::Request>, std::shared_ptr<std_srvs::srv::Empty::Response>) {}

  int level_ = 0;
  int step_;
  bool loud_;
  rclcpp::Publisher<std_msgs::msg::Int32>::SharedPtr count_pub_;
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr other_pub_, ready_pub_;
  rclcpp::Subscription<std_msgs::msg::Int32>::SharedPtr level_sub_;
  std::shared_ptr<Server<std_srvs::srv::Trigger>> server_;
  std::shared_ptr<Delegating<std_srvs::srv::Empty>> halt_;
  rclcpp::TimerBase::SharedPtr timer_;
  OnSetParametersCallbackHandle::SharedPtr handle_;  // by the name that the class of the node has for it
  rclcpp::QOSMessageLostCallbackType on_lost_;
};

RCLCPP_COMPONENTS_REGISTER_NODE(Counter)
