// A server of actions that is never started, and that ends no goal.
//
// expect: 1 = count : { misused(_, "server not started", _) }
// expect: 1 = count : { misused(_, "goal not ended", "dock") }
#include <actionlib/TestAction.h>
#include <actionlib/server/simple_action_server.h>
#include <ros/ros.h>

class Dock {
public:
  Dock() : server_(nh_, "dock", boost::bind(&Dock::run, this, _1), false) {}

private:
  void run(const actionlib::TestGoalConstPtr& goal) { ROS_INFO("%d", goal->goal); }
  ros::NodeHandle nh_;
  actionlib::SimpleActionServer<actionlib::TestAction> server_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "dock");
  Dock dock;
  ros::spin();
}
