// A server of actions that is started, and ends its goals.
//
// expect: 0 = count : { misused(_, _, _) }
#include <actionlib/TestAction.h>
#include <actionlib/server/simple_action_server.h>
#include <ros/ros.h>

class Dock {
public:
  Dock() : server_(nh_, "dock", boost::bind(&Dock::run, this, _1), false) { server_.start(); }

private:
  void run(const actionlib::TestGoalConstPtr&) { server_.setSucceeded(); }
  ros::NodeHandle nh_;
  actionlib::SimpleActionServer<actionlib::TestAction> server_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "dock");
  Dock dock;
  ros::spin();
}
