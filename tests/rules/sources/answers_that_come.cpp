// Servers that answer in any case: one that counts, and one that only decides; not one that waits for something, or that may go on in a loop.
//
// expect: answers_surely([_, "action_server", "counts"])
// expect: answers_surely([_, "service_server", "decides"])
// expect: 2 = count : { answers_surely(_) }
#include <actionlib/server/simple_action_server.h>
#include <actionlib/TestAction.h>
#include <ros/ros.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

typedef actionlib::SimpleActionServer<actionlib::TestAction> Server;

class Node {
public:
  Node()
      : counts_(nh_, "counts", boost::bind(&Node::count, this, _1), false), goes_on_(nh_, "goes_on", boost::bind(&Node::goOn, this, _1), false) {
    counts_.start();
    goes_on_.start();
    decides_ = nh_.advertiseService("decides", &Node::decide, this);
    asks_ = nh_.advertiseService("asks", &Node::ask, this);
    other_ = nh_.serviceClient<std_srvs::Trigger>("other");
  }

private:
  void count(const actionlib::TestGoalConstPtr& goal) {
    ros::Rate rate(10);
    for (int i = 0; i < goal->goal && ros::ok(); ++i) rate.sleep();
    counts_.setSucceeded();
  }
  void goOn(const actionlib::TestGoalConstPtr&) {
    while (!goes_on_.isPreemptRequested()) ros::Duration(0.1).sleep();
    goes_on_.setPreempted();
  }
  bool decide(std_srvs::SetBool::Request& request, std_srvs::SetBool::Response& response) {
    response.success = isWanted(request.data);
    return true;
  }
  bool isWanted(bool data) { return data; }
  bool ask(std_srvs::Trigger::Request&, std_srvs::Trigger::Response&) {
    std_srvs::Trigger trigger;
    return other_.call(trigger);
  }

  ros::NodeHandle nh_;
  Server counts_, goes_on_;
  ros::ServiceServer decides_, asks_;
  ros::ServiceClient other_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  ros::spin();
}
