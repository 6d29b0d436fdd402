// Numbers that are given to variables of another type: a fraction that is cut off, a number that has more bits; not one of the same type.
//
// expect: converted(E), assignment(E, V, _), variable_name(V, "whole_")
// expect: converted(E), assignment(E, V, _), variable_name(V, "byte_")
// expect: 2 = count : { converted(_) }
// expect: cast_written(_, "static_cast<int>(msg.data)")
// expect: 0 = count : { settled_local(_, "cut", _) }
// expect: settled_local(_, "level", _)
#include <ros/ros.h>
#include <std_msgs/Empty.h>
#include <std_msgs/Float64.h>
#include <std_msgs/Int32.h>
#include <std_msgs/UInt8.h>

class Node
{
public:
  Node()
  {
    pub_ = nh_.advertise<std_msgs::Empty>("out", 1);
    level_ = nh_.subscribe("level", 1, &Node::onLevel, this);
    number_ = nh_.subscribe("number", 1, &Node::onNumber, this);
    small_ = nh_.subscribe("small", 1, &Node::onSmall, this);
    timer_ = nh_.createTimer(ros::Duration(1.0), &Node::tick, this);
  }

private:
  void onLevel(const std_msgs::Float64& msg)
  {
    whole_ = msg.data;
    fraction_ = msg.data;
    int cut = msg.data;
    if (cut == 0) pub_.publish(std_msgs::Empty());
    double level = msg.data;
    if (level > 0.5) pub_.publish(std_msgs::Empty());
    if (static_cast<int>(msg.data) == 3) pub_.publish(std_msgs::Empty());
  }
  void onNumber(const std_msgs::Int32& msg) { byte_ = msg.data; }
  void onSmall(const std_msgs::UInt8& msg) { number = msg.data; }
  void tick(const ros::TimerEvent&)
  {
    if (whole_ == 0 || fraction_ > 0.5 || byte_ == 3 || number == 4) pub_.publish(std_msgs::Empty());
  }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber level_, number_, small_;
  ros::Timer timer_;
  int whole_ = 0;
  double fraction_ = 0;
  uint8_t byte_ = 0;
  int number = 0;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
