// Publishers in maps and in structures that lists hold: loops take the elements apart, by structured bindings or by their data members.
//
// expect: reactive map -> one may
// expect: reactive map -> two may
// expect: reactive structures -> three must
// expect: reactive members -> three must
// expect: reactive pairs -> four must
// expect: reactive first -> three must
// expect: reactive made -> five must
// expect: 7 = count : { reacts(_, _, _) }
#include <map>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/string.hpp>
#include <string>
#include <utility>
#include <vector>

using std_msgs::msg::String;

struct Output
{
  rclcpp::Publisher<String>::SharedPtr publisher;
  int priority;
};

class Fan : public rclcpp::Node
{
public:
  Fan() : Node("fan")
  {
    by_name_["one"] = create_publisher<String>("one", 1);
    by_name_.insert({"two", create_publisher<String>("two", 1)});
    outputs_.push_back({create_publisher<String>("three", 1), 3});
    pairs_.push_back(std::make_pair(1, create_publisher<String>("four", 1)));
    made_ = create_publisher<String>("five", 1);
    map_ = create_subscription<String>("map", 1, [this](String::ConstSharedPtr message) {
      for (auto & [name, publisher] : by_name_) publisher->publish(*message);
    });
    structures_ = create_subscription<String>("structures", 1, [this](String::ConstSharedPtr message) {
      for (const auto & [publisher, priority] : outputs_) publisher->publish(*message);
    });
    members_ = create_subscription<String>("members", 1, [this](String::ConstSharedPtr message) {
      for (const auto & output : outputs_) output.publisher->publish(*message);
    });
    in_pairs_ = create_subscription<String>("pairs", 1, [this](String::ConstSharedPtr message) {
      for (const auto & [number, publisher] : pairs_) publisher->publish(*message);
    });
    first_ = create_subscription<String>("first", 1, [this](String::ConstSharedPtr message) {
      const auto [publisher, priority] = outputs_.front();
      publisher->publish(*message);
    });
    sent_ = create_subscription<String>("made", 1, [this](String::ConstSharedPtr message) { const auto [done, code] = send(*message); });
  }

private:
  std::pair<bool, int> send(const String & message)
  {
    made_->publish(message);
    return {true, 0};
  }

  std::map<std::string, rclcpp::Publisher<String>::SharedPtr> by_name_;
  std::vector<Output> outputs_;
  std::vector<std::pair<int, rclcpp::Publisher<String>::SharedPtr>> pairs_;
  rclcpp::Publisher<String>::SharedPtr made_;
  rclcpp::Subscription<String>::SharedPtr map_, structures_, members_, in_pairs_, first_, sent_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Fan>());
}
