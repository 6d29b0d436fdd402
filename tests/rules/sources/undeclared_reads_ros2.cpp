// Parameters that are asked for or set and not declared: an exception, or what the code says. Others are declared, asked about, declared by every node, or their exception is handled.
//
// expect: undeclared_read(_, "rate", "thrown")
// expect: undeclared_read(_, "limit", "quiet")
// expect: undeclared_read(_, "size", "quiet")
// expect: undeclared_read(_, "depth", "set")
// expect: undeclared_read(_, "mass", "set")
// expect: 5 = count : { undeclared_read(_, _, _) }
#include <rclcpp/rclcpp.hpp>

class Driver : public rclcpp::Node {
public:
  Driver() : Node("driver") {
    declare_parameter("name", "x");
    declareAll("width");
    name_ = get_parameter("name").as_string();
    rate_ = get_parameter("rate").as_double();
    get_parameter("limit", limit_);
    get_parameter_or("size", size_, 3.0);
    get_parameter("width", width_);
    if (has_parameter("extra")) get_parameter("extra", extra_);
    set_parameter(rclcpp::Parameter("depth", 1.0));
    set_parameters({rclcpp::Parameter("mass", 1.0), rclcpp::Parameter("name", "y"), rclcpp::Parameter("extra", 1.0)});
    get_parameter("mass", mass_);
    try {
      set_parameter(rclcpp::Parameter("older", 1.0));
    } catch (const rclcpp::exceptions::ParameterNotDeclaredException&) {
      old_ = 0.0;
    }
    simulated_ = get_parameter("use_sim_time").as_bool();
    try {
      old_ = get_parameter("old").as_double();
    } catch (const rclcpp::exceptions::ParameterNotDeclaredException&) {
      old_ = 0.0;
    }
  }

private:
  void declareAll(const std::string& name) { declare_parameter(name, 1.0); }
  std::string name_;
  bool simulated_;
  double rate_, limit_, size_, width_, extra_, old_, mass_;
};

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Driver>());
}
