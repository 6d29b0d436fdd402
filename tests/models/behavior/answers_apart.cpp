// What answers to a goal lead to: each callback has conditions of its own.
//
// expect: reactive go -> done may [state == actionlib::SimpleClientGoalState::SUCCEEDED]
// normal: reactive go -> done [state == actionlib::SimpleClientGoalState::SUCCEEDED]
// expect: reactive go -> going must []
// normal: reactive go -> going []
#include <actionlib/client/simple_action_client.h>
#include <actionlib_tutorials/FibonacciAction.h>
#include <ros/ros.h>
#include <std_msgs/Empty.h>

class Node {
public:
  Node() : client_("go", true) {
    done_ = nh_.advertise<std_msgs::Empty>("done", 1);
    going_ = nh_.advertise<std_msgs::Empty>("going", 1);
    client_.sendGoal(actionlib_tutorials::FibonacciGoal(), boost::bind(&Node::onDone, this, _1, _2), boost::bind(&Node::onActive, this));
  }

private:
  void onDone(const actionlib::SimpleClientGoalState& state, const actionlib_tutorials::FibonacciResultConstPtr&) {
    if (state == actionlib::SimpleClientGoalState::SUCCEEDED) done_.publish(std_msgs::Empty());
  }

  void onActive() { going_.publish(std_msgs::Empty()); }

  ros::NodeHandle nh_;
  actionlib::SimpleActionClient<actionlib_tutorials::FibonacciAction> client_;
  ros::Publisher done_, going_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
