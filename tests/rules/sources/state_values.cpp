// Where the first value of state comes from, and which locals stand for state in a condition.
//
// expect: state mode_ = 1
// expect: state flag_ = false
// expect: reactive /settled -> /out if settled
// expect: Count = count : { settled_local(E, Name, Value) }, Count = 1
// expect: settled_local(_, "settled", _)
#include <ros/ros.h>
#include <std_msgs/Int32.h>

class Node
{
public:
  Node() : mode_(1), flag_(false)
  {
    pub_ = nh_.advertise<std_msgs::Int32>("/out", 1);
    mode_sub_ = nh_.subscribe("/mode", 1, &Node::onMode, this);
    settled_sub_ = nh_.subscribe("/settled", 1, &Node::onSettled, this);
    touched_sub_ = nh_.subscribe("/touched", 1, &Node::onTouched, this);
  }

private:
  void onMode(const std_msgs::Int32& message)
  {
    mode_ = message.data;
    flag_ = pick(message.data);
    if (mode_ > 2 && flag_)
      count_ = mode_;
  }

  bool pick(int number)
  {
    bool large = false;
    if (number > 100)
      large = true;
    return large;
  }

  void onSettled(const std_msgs::Int32& message)
  {
    bool settled = count_ > 3;
    if (settled)
      pub_.publish(message);
  }

  void change(int& number)
  {
    number = 5;
  }

  void onTouched(const std_msgs::Int32& message)
  {
    int added = count_;
    added += 2;
    if (added > 2)
      pub_.publish(message);
    int passed = count_;
    change(passed);
    if (passed > 2)
      pub_.publish(message);
    int pointed = count_;
    int* pointer = &pointed;
    *pointer = 2;
    if (pointed > 2)
      pub_.publish(message);
    int own = count_++;
    if (own > 2)
      pub_.publish(message);
    int* made = new int(3);
    if (made)
      pub_.publish(message);
    auto function = [] { return true; };
    if (function)
      pub_.publish(message);
  }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Subscriber mode_sub_, settled_sub_, touched_sub_;
  int mode_, count_ = 0;
  bool flag_;
};

int main(int argc, char** argv)
{
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
