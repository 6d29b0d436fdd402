// Qualities of service: made in one go, changed by and by, of classes and functions of their own, taken from a type, left out.
//
// expect: publisher chained std_msgs/Bool queue=3 latched
// expect: publisher numbered std_msgs/Bool queue=7 latched=false
// expect: port_quality([_, _, "numbered"], "reliability", "reliable")
// expect: publisher sensed std_msgs/Bool queue=5 latched=false
// expect: port_quality([_, _, "sensed"], "reliability", "best_effort")
// expect: port_quality([_, _, "sensed"], "profile", "sensor_data")
// expect: publisher changed std_msgs/Bool queue=4 latched
// expect: N = count : { port_quality([_, _, "changed"], "reliability", "reliable") }, N = 0
// expect: publisher before std_msgs/Bool queue=2 latched=false
// expect: publisher own std_msgs/Bool queue=6 latched
// expect: publisher narrow std_msgs/Bool queue=1 latched
// expect: port_quality([_, _, "narrow"], "reliability", "best_effort")
// expect: publisher profiled std_msgs/Bool queue=9 latched=false
// expect: port_quality([_, _, "profiled"], "reliability", "best_effort")
// expect: publisher all std_msgs/Bool latched=false
// expect: N = count : { port_queue([_, _, "all"], _) }, N = 0
// expect: port_quality([_, _, "all"], "history", "keep_all")
// expect: publisher /of_type std_msgs/Bool queue=8 latched
// expect: publisher /of_local std_msgs/Bool queue=8 latched
// expect: port_quality([_, _, "/of_local"], "reliability", "best_effort")
// expect: publisher handed std_msgs/Bool queue=12 latched
// expect: publisher defaulted std_msgs/Bool queue=11 latched=false
// expect: publisher copied std_msgs/Bool queue=3 latched
// expect: publisher set std_msgs/Bool queue=13 latched
// expect: publisher asked std_msgs/Bool queue=1 latched=false
// expect: publisher unknown std_msgs/Bool latched=false
// expect: N = count : { port_queue([_, _, "unknown"], _) }, N = 0
// expect: N = count : { port_quality([_, _, "unknown"], _, _) }, N = 0
// expect: service_server reset std_srvs/Trigger
// expect: port_quality([_, _, "reset"], "profile", "services")
// expect: service_client other std_srvs/Trigger
// expect: port_quality([_, _, "other"], "reliability", "best_effort")
// expect: N = count : { port_queue(_, _) }, N = 15, 6 = count : { result_value(_, _) }
// expect: 3 = count : { base_part(_) }
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_srvs/srv/trigger.hpp>

class Wide : public rclcpp::QoS
{
public:
  explicit Wide(int depth = 6) : rclcpp::QoS(rclcpp::KeepLast(depth))
  {
    this->best_effort().transient_local();
  }
};

class Narrow : public Wide
{
public:
  Narrow() : Wide(1) {}
};

struct Spec
{
  static constexpr char name[] = "/of_type";
  static constexpr size_t depth = 8;
  static constexpr auto reliability = RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT;
  static constexpr auto durability = RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL;
};

template <class T>
rclcpp::QoS quality_of()
{
  return rclcpp::QoS{T::depth}.reliability(T::reliability).durability(T::durability);
}

template <class T>
rclcpp::QoS local_quality_of()
{
  rclcpp::QoS qos(T::depth);
  qos.reliability(T::reliability);
  qos.durability(T::durability);
  return qos;
}

template <class T>
rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr publisher_of(rclcpp::Node * node)
{
  return node->create_publisher<std_msgs::msg::Bool>(T::name, quality_of<T>());
}

rclcpp::QoS any_quality(int which);

class Talker : public rclcpp::Node
{
public:
  Talker() : Node("talker")
  {
    add(create_publisher<std_msgs::msg::Bool>("chained", rclcpp::QoS(rclcpp::KeepLast(3)).reliable().transient_local()));
    add(create_publisher<std_msgs::msg::Bool>("numbered", 7));
    add(create_publisher<std_msgs::msg::Bool>("sensed", rclcpp::SensorDataQoS()));
    rclcpp::QoS qos(2);
    add(create_publisher<std_msgs::msg::Bool>("before", qos));
    qos.best_effort().transient_local();
    qos.keep_last(4);
    add(create_publisher<std_msgs::msg::Bool>("changed", qos));
    add(create_publisher<std_msgs::msg::Bool>("own", Wide()));
    add(create_publisher<std_msgs::msg::Bool>("narrow", Narrow()));
    add(create_publisher<std_msgs::msg::Bool>("profiled", rclcpp::QoS(rclcpp::KeepLast(9), rmw_qos_profile_sensor_data)));
    add(create_publisher<std_msgs::msg::Bool>("all", rclcpp::QoS(10).keep_all()));
    add(publisher_of<Spec>(this));
    add(create_publisher<std_msgs::msg::Bool>("/of_local", local_quality_of<Spec>()));
    add(made("handed", rclcpp::QoS(12).transient_local()));
    add(made("defaulted"));
    add(create_publisher<std_msgs::msg::Bool>("copied", rclcpp::QoS(qos_)));
    rmw_qos_profile_t profile = rmw_qos_profile_default;
    profile.depth = 13;
    profile.durability = RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL;
    add(create_publisher<std_msgs::msg::Bool>("set", rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(profile), profile)));
    auto asked = rclcpp::QoS(1);
    if (declare_parameter("latched", false)) {
      asked.transient_local();
    }
    add(create_publisher<std_msgs::msg::Bool>("asked", asked));
    add(create_publisher<std_msgs::msg::Bool>("unknown", any_quality(1)));
    reset_ = create_service<std_srvs::srv::Trigger>(
      "reset", [](const std_srvs::srv::Trigger::Request::SharedPtr, std_srvs::srv::Trigger::Response::SharedPtr) {});
    other_ = create_client<std_srvs::srv::Trigger>("other", rclcpp::ServicesQoS().best_effort());
  }

private:
  rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr made(const std::string & name, const rclcpp::QoS & qos = rclcpp::QoS(11))
  {
    return create_publisher<std_msgs::msg::Bool>(name, qos);
  }

  void add(rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr publisher) {publishers_.push_back(publisher);}

  rclcpp::QoS qos_ = rclcpp::QoS(3).transient_local();
  std::vector<rclcpp::Publisher<std_msgs::msg::Bool>::SharedPtr> publishers_;
  rclcpp::Service<std_srvs::srv::Trigger>::SharedPtr reset_;
  rclcpp::Client<std_srvs::srv::Trigger>::SharedPtr other_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Talker>());
}
