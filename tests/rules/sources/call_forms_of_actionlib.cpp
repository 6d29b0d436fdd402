// Action servers that are started by the constructors that make them: by a flag, for want of one, or by what the constructor is given.
//
// expect: 6 = count : { starts_in_constructor(_, _, _) }
// expect: starts_in_constructor(S, S, "told"), port([S, _, "flag"])
// expect: starts_in_constructor(S, S, "told"), port([S, _, "left"])
// expect: starts_in_constructor(S, S, "told"), port([S, _, "simple"])
// expect: starts_in_constructor(S, S, "told"), port([S, _, "bare"])
// expect: starts_in_constructor(S, C, "told"), port([S, _, "given"]), S != C, location(C, _, 47, _)
// expect: starts_in_constructor(S, C, "told"), port([S, _, "by_default"]), S != C, location(C, _, 49, _)
#include <actionlib/server/action_server.h>
#include <actionlib/server/simple_action_server.h>
#include <ros/ros.h>
#include <tf2_msgs/LookupTransformAction.h>

using Server = actionlib::ActionServer<tf2_msgs::LookupTransformAction>;
using Simple = actionlib::SimpleActionServer<tf2_msgs::LookupTransformAction>;

class Cook {
public:
  Cook(ros::NodeHandle& nh, bool later)
      : flag_(nh, "flag", boost::bind(&Cook::onGoal, this, _1), true), left_(nh, "left", boost::bind(&Cook::onGoal, this, _1)),
        simple_("simple", boost::bind(&Cook::onSimple, this, _1)), bare_(nh, "bare"), off_(nh, "off", boost::bind(&Cook::onGoal, this, _1), false),
        later_(nh, "later", boost::bind(&Cook::onGoal, this, _1), later) {}

private:
  void onGoal(Server::GoalHandle goal) { goal.setAccepted(); }
  void onSimple(const tf2_msgs::LookupTransformGoalConstPtr&) {}
  Server flag_, left_;
  Simple simple_, bare_;
  Server off_, later_;
};

class Waiter {
public:
  Waiter(ros::NodeHandle& nh, const char* name, bool starts = true) : server_(nh, name, boost::bind(&Waiter::onGoal, this, _1), starts) {}

private:
  void onGoal(Server::GoalHandle goal) { goal.setAccepted(); }
  Server server_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "kitchen");
  ros::NodeHandle nh;
  bool later = argc > 1;
  Cook cook(nh, later);
  Waiter given(nh, "given", true);
  Waiter off(nh, "never", false);
  Waiter by_default(nh, "by_default");
  Server outside(nh, "outside", true);
  ros::spin();
}
