// What gets a node and was not seen: functions, classes, methods and macros that nothing declares, and what has no body. What is known leaves it closed.
//
// expect: open_at("ports", C, ["handed", "absent_a::attach"])
// expect: open_at("params", C, ["handed", "absent_a::attach"])
// expect: open_at("ports", C, ["handed", "absent_a::Base"])
// expect: open_at("ports", C, ["handed", "absent_a::Third"])
// expect: open_at("ports", C, ["handed", "ABSENT_MACRO"])
// expect: open_at("ports", C, ["handed", "init"])
// expect: open_at("ports", C, ["handed", "start"])
// expect: open_at("ports", C, ["undefined", "setup_things"])
// expect: open_at("ports", C, ["undefined", "Declared::Declared"])
// expect: Count = count : { open_at("ports", C, ["handed", Name]) }, Count = 6
// expect: unseen("ports", "handed", "absent_a::attach", Path, 41, 5)
// expect: Count = count : { open_line("ports", F, Line, ["macro", Name]) }, Count = 1
// expect-not: open_at("ports", C, ["handed", "absent_a::log"])
#include <absent_a/a.hpp>
#include <diagnostic_updater/diagnostic_updater.hpp>
#include <rclcpp/rclcpp.hpp>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

void setup_things(rclcpp::Node& node);
void defined(rclcpp::Node& node) { node.set_parameter(rclcpp::Parameter("a", 1)); }

class Declared
{
public:
  explicit Declared(rclcpp::Node* node);
};

class One : public absent_a::Base, public rclcpp::Node
{
public:
  One() : absent_a::Base(this), rclcpp::Node("one"), updater_(this), declared_(this)
  {
    buffer_ = std::make_unique<tf2_ros::Buffer>(get_clock());
    listener_ = std::make_shared<tf2_ros::TransformListener>(*buffer_, this);
    absent_a::log("made", get_logger());
    defined(*this);
    setup_things(*this);
    absent_a::attach(this, "free");
    helper_.init(this);
    helper_.start(get_node_topics_interface());
    third_ = std::make_shared<absent_a::Third>(shared_from_this());
    ABSENT_MACRO(this);
  }

  ABSENT_PARTS(One)
  EIGEN_MAKE_ALIGNED_OPERATOR_NEW

  absent_a::Helper helper_;
  std::shared_ptr<absent_a::Third> third_;
  diagnostic_updater::Updater updater_;
  Declared declared_;
  std::unique_ptr<tf2_ros::Buffer> buffer_;
  std::shared_ptr<tf2_ros::TransformListener> listener_;
};

int main(int argc, char** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<One>());
}
