// expect: perhaps_always in of_list
// expect: perhaps_always in of_member
// expect: perhaps_always in through_call
#include <ros/ros.h>
#include <std_msgs/Int32.h>
#include <std_msgs/Int32MultiArray.h>
#include <vector>

class Node {
public:
  Node() {
    of_list_ = nh_.advertise<std_msgs::Int32>("of_list", 1);
    of_member_ = nh_.advertise<std_msgs::Int32>("of_member", 1);
    through_call_ = nh_.advertise<std_msgs::Int32>("through_call", 1);
    thrice_ = nh_.advertise<std_msgs::Int32>("thrice", 1);
    of_array_ = nh_.advertise<std_msgs::Int32>("of_array", 1);
    in_ = nh_.subscribe("in", 1, &Node::onIn, this);
  }

private:
  void tell(const std_msgs::Int32& out) { through_call_.publish(out); }

  void onIn(const std_msgs::Int32MultiArray& list) {
    std_msgs::Int32 out;
    for (int each : list.data) {
      out.data = each;
      of_list_.publish(out);
      tell(out);
    }
    for (size_t i = 0; i < kept_.size(); ++i) of_member_.publish(out);
    for (int i = 0; i < 3; ++i) thrice_.publish(out);
    int two[2] = {1, 2};
    for (int each : two) of_array_.publish(out);
  }

  ros::NodeHandle nh_;
  ros::Publisher of_list_, of_member_, through_call_, thrice_, of_array_;
  ros::Subscriber in_;
  std::vector<int> kept_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
