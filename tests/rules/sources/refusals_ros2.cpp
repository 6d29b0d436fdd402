// Values of parameters that a node refuses when it starts: texts, numbers, lengths, one beside another; alternatives and else-branches. Not told: exceptions that are handled, conditions on other things,
// what only some configurations get to, a variable that is changed in between.
//
// expect: refuses_other_text(_, "mode", "fast")
// expect: refuses_other_text(_, "mode", "exact")
// expect: refuses_other_text(_, "kind", "a")
// expect: refuses_other_text(_, "kind", "b")
// expect: refuses_number(_, "rate", "value", "<=", "0.0")
// expect: refuses_number(_, "size", "value", "<", "1")
// expect: refuses_number(_, "size", "value", ">", "9")
// expect: refuses_number(_, "noise", "length", "!=", "3")
// expect: refuses_number(_, "names", "length", "==", "0")
// expect: refuses_number(_, "offset", "value", "<", "-2")
// expect: refuses_pair(_, "low", ">=", "high")
// expect: 4 = count : { refuses_other_text(_, _, _) }
// expect: 6 = count : { refuses_number(_, _, _, _, _) }
// expect: 1 = count : { refuses_pair(_, _, _, _) }
#include <rclcpp/rclcpp.hpp>
#include <stdexcept>

class Driver : public rclcpp::Node {
public:
  Driver() : Node("driver") {
    mode_ = declare_parameter<std::string>("mode", "fast");
    if (mode_ != "fast" && mode_ != "exact") throw std::invalid_argument("mode");
    declare_parameter("rate", 10.0);
    rate_ = get_parameter("rate").as_double();
    if (!(rate_ > 0.0)) throw std::invalid_argument("rate");
    const int size = declare_parameter<int>("size", 3);
    if (size < 1 || 9 < size) throw std::invalid_argument("size");
    std::vector<double> noise = declare_parameter("noise", std::vector<double>());
    if (noise.size() != 3) throw std::invalid_argument("noise");
    std::vector<std::string> names = declare_parameter("names", std::vector<std::string>());
    if (names.empty()) throw std::invalid_argument("names");
    const double low = declare_parameter<double>("low", 0.0);
    const double high = declare_parameter<double>("high", 1.0);
    if (low >= high) throw std::invalid_argument("low");
    const std::string kind = declare_parameter<std::string>("kind", "a");
    if (kind == "a") {
      factor_ = 2.0;
    } else if (kind == "b") {
      factor_ = 3.0;
    } else {
      throw std::invalid_argument("kind");
    }
    const int offset = declare_parameter<int>("offset", 0);
    if (offset < -2) throw std::invalid_argument("offset");

    const std::string handled = declare_parameter<std::string>("handled", "a");
    try {
      if (handled != "a") throw std::invalid_argument("handled");
    } catch (const std::invalid_argument&) {
    }
    const std::string part = declare_parameter<std::string>("part", "a");
    if (part != "a" && size != 2) throw std::invalid_argument("part");
    if (size == 2) {
      if (part != "b") throw std::invalid_argument("part");
    }
    std::string changed = declare_parameter<std::string>("changed", "a");
    changed = changed + "x";
    if (changed != "ax") throw std::invalid_argument("changed");
    timer_ = create_wall_timer(std::chrono::seconds(1), [this]() {
      const int later = get_parameter("size").as_int();
      if (later == 4) throw std::invalid_argument("later");
    });
  }

private:
  std::string mode_;
  double rate_ = 0.0;
  double factor_ = 1.0;
  rclcpp::TimerBase::SharedPtr timer_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Driver>());
}
