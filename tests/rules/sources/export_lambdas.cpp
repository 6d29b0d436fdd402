// Callbacks without a name are told by the function that they are written in; one that only passes on is told as what it calls.
//
// expect: lambda_within(F, G), function_display(G, "Node", "Node::Node")
// expect: lambda_within(F, G), function_display(G, "", "listen")
// expect: N = count : { lambda_within(_, _) }, N = 4
// expect: function_display(F, "Node", "Node::onScan"), function(F, "lambda")
// expect-not: function_display(_, "Node", "Node::halved")
#include <ros/ros.h>
#include <std_msgs/Bool.h>
#include <std_msgs/Float64.h>
#include <vector>

class Node
{
public:
  Node()
  {
    stop_ = nh_.subscribe<std_msgs::Bool>("stop", 1, [this](const std_msgs::BoolConstPtr& msg) { stopped_ = msg->data; });
    scan_ = nh_.subscribe<std_msgs::Bool>("scan", 1, [this](const std_msgs::BoolConstPtr& msg) { onScan(msg); });
    level_ = nh_.subscribe<std_msgs::Float64>("level", 1, [this](const std_msgs::Float64ConstPtr& msg) { levels_.push_back(halved(msg->data)); });
    auto later = [this]() {
      go_ = nh_.subscribe<std_msgs::Bool>("go", 1, [this](const std_msgs::BoolConstPtr& msg) { stopped_ = !msg->data; });
    };
    later();
  }

private:
  void onScan(const std_msgs::BoolConstPtr& msg)
  {
    stopped_ = stopped_ || msg->data;
  }

  double halved(double value) const
  {
    return value / 2;
  }

  ros::NodeHandle nh_;
  ros::Subscriber stop_, scan_, level_, go_;
  bool stopped_ = false;
  std::vector<double> levels_;
};

ros::Subscriber listen(ros::NodeHandle& nh, bool& value)
{
  auto keep = [&value](const std_msgs::BoolConstPtr& msg) { value = msg->data; };
  return nh.subscribe<std_msgs::Bool>("value", 1, keep);
}

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  Node node;
  bool value = false;
  ros::NodeHandle nh;
  ros::Subscriber sub = listen(nh, value);
  ros::spin();
}
