// Times in qualities of service: given directly, through variables, in parts; what is set but not told.
//
// expect: port_quality([_, _, "direct"], "deadline", "(100)/(1000.0)")
// expect: port_quality([_, _, "direct"], "lifespan", "(2)/(1.0)")
// expect: port_quality([_, _, "direct"], "lease_duration", "(500000000)/(1000000000.0)")
// expect: port_quality([_, _, "seconds"], "deadline", "(0.25)/(1.0)")
// expect: port_quality([_, _, "variable"], "deadline", "(30)/(1000.0)")
// expect: port_quality([_, _, "converted"], "deadline", "(40)/(1000.0)")
// expect: port_quality([_, _, "member"], "deadline", "(1)/(1.0)")
// expect: port_quality([_, _, "handed"], "deadline", "(7)/(1.0)")
// expect: port_quality([_, _, "argument"], "deadline", "unknown")
// expect: port_quality([_, _, "perhaps"], "deadline", "unknown")
// expect: N = count : { port_quality([_, _, "none"], "deadline", _) }, N = 0
// expect: port_quality([_, _, "none"], "history", "keep_last")
// expect: N = count : { port_quality([_, _, "taken_back"], "deadline", _) }, N = 1
// expect: N = count : { port_quality(_, Policy, _), match("deadline|lifespan|lease_duration", Policy) }, N = 11
// expect: periodic direct 10 Hz mechanism=timer
#include <chrono>
#include <memory>
#include <string>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/bool.hpp>

using namespace std::chrono_literals;
using std_msgs::msg::Bool;

class Talker : public rclcpp::Node
{
public:
  explicit Talker(int period) : Node("talker")
  {
    direct_ = create_publisher<Bool>(
      "direct", rclcpp::QoS(10).deadline(std::chrono::milliseconds(100)).lifespan(2s).liveliness_lease_duration(rclcpp::Duration(0, 500000000)));
    seconds_ = create_publisher<Bool>("seconds", rclcpp::QoS(1).deadline(rclcpp::Duration::from_seconds(0.25)));
    const auto deadline = 30ms;
    rclcpp::QoS qos(2);
    qos.deadline(deadline);
    variable_ = create_publisher<Bool>("variable", qos);
    const rclcpp::Duration converted(40ms);
    converted_ = create_publisher<Bool>("converted", rclcpp::QoS(1).deadline(converted));
    member_ = create_publisher<Bool>("member", rclcpp::QoS(1).deadline(limit_));
    handed_ = create_publisher<Bool>("handed", within(7s));
    argument_ = create_publisher<Bool>("argument", rclcpp::QoS(1).deadline(std::chrono::milliseconds(period)));
    rclcpp::QoS perhaps(1);
    if (period > 0) {
      perhaps.deadline(5ms);
    }
    perhaps_ = create_publisher<Bool>("perhaps", perhaps);
    none_ = create_publisher<Bool>("none", 3);
    taken_back_ = create_publisher<Bool>("taken_back", rclcpp::QoS(1).deadline(5ms).deadline(6ms));
    const rclcpp::Duration round(100ms);
    timer_ = rclcpp::create_timer(this, get_clock(), round, [this]() {direct_->publish(Bool());});
  }

private:
  static rclcpp::QoS within(std::chrono::seconds time)
  {
    return rclcpp::QoS(1).deadline(time);
  }

  std::chrono::seconds limit_{1};
  rclcpp::Publisher<Bool>::SharedPtr direct_, seconds_, variable_, converted_, member_, handed_, argument_, perhaps_, none_, taken_back_;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Talker>(std::stoi(argv[1])));
}
