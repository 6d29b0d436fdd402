// A type in place of a default tells no value: what the declaration gives is named by the parameter alone.
//
// expect: subscriber ? from_param=topics.input
// expect: publisher ? from_param=topics.output
// expect: publisher spare from_param=topics.spare
// expect: param topics.input
// expect: param topics.output
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/empty.hpp>

using rclcpp::ParameterType::PARAMETER_STRING;

class Board : public rclcpp::Node {
public:
  Board() : Node("board")
  {
    std::string input = this->declare_parameter("topics.input", PARAMETER_STRING).get<std::string>();
    in_ = create_subscription<std_msgs::msg::Empty>(input, 1, [](std_msgs::msg::Empty::ConstSharedPtr) {});
    declare_parameter("topics.output", rclcpp::ParameterType::PARAMETER_STRING);
    out_ = create_publisher<std_msgs::msg::Empty>(get_parameter("topics.output").as_string(), 1);
    spare_ = create_publisher<std_msgs::msg::Empty>(declare_parameter<std::string>("topics.spare", "spare"), 1);
  }

private:
  rclcpp::Subscription<std_msgs::msg::Empty>::SharedPtr in_;
  rclcpp::Publisher<std_msgs::msg::Empty>::SharedPtr out_, spare_;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Board>());
}
