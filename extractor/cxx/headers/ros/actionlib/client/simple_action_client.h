// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <actionlib/client/client_states.h>
#include <actionlib/action_types.h>
namespace actionlib {
template <class ActionSpec> class SimpleActionClient {
public:
  ACTION_DEFINITION(ActionSpec)
  typedef SimpleActionClient<ActionSpec> SimpleActionClientT;
    typedef boost::function<void(const SimpleClientGoalState&, const ResultConstPtr&)> SimpleDoneCallback;
    typedef boost::function<void()> SimpleActiveCallback; typedef boost::function<void(const FeedbackConstPtr&)> SimpleFeedbackCallback;
  SimpleActionClient(const std::string& name, bool spin_thread = true);
  SimpleActionClient(const ros::NodeHandle&, const std::string& name, bool spin_thread = true);
  bool waitForServer(const ros::Duration& timeout = ros::Duration(0, 0)) const; bool isServerConnected() const;
  // (goal[, done callback][, active callback][, feedback callback])
  template <class G, class... A> void sendGoal(const G& goal, const A&...);
  template <class G> SimpleClientGoalState sendGoalAndWait(const G& goal, const ros::Duration& = ros::Duration(0, 0),
    const ros::Duration& = ros::Duration(0, 0));
  bool waitForResult(const ros::Duration& timeout = ros::Duration(0, 0)); ResultConstPtr getResult() const;
    SimpleClientGoalState getState() const;
  void cancelAllGoals(); void cancelGoalsAtAndBeforeTime(const ros::Time&); void cancelGoal(); void stopTrackingGoal();
};
}
