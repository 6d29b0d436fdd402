// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <actionlib/action_types.h>
namespace actionlib {
template <class ActionSpec> class ServerGoalHandle {
public:
  ACTION_DEFINITION(ActionSpec)
  void setAccepted(const std::string& = ""); void setCanceled(const Result& = Result(), const std::string& = "");
    void setRejected(const Result& = Result(), const std::string& = ""); void setAborted(const Result& = Result(), const std::string& = "");
    void setSucceeded(const Result& = Result(), const std::string& = ""); bool setCancelRequested();
  void publishFeedback(const Feedback&); bool isValid() const; GoalConstPtr getGoal() const; actionlib_msgs::GoalID getGoalID() const;
    actionlib_msgs::GoalStatus getGoalStatus() const; bool operator==(const ServerGoalHandle&) const;
    bool operator!=(const ServerGoalHandle&) const;
};
template <class ActionSpec> class ActionServer {
public:
  ACTION_DEFINITION(ActionSpec)
  typedef ServerGoalHandle<ActionSpec> GoalHandle;
  template <class... A> ActionServer(const ros::NodeHandle&, const std::string& name, const A&...);
  template <class F> void registerGoalCallback(const F&); template <class F> void registerCancelCallback(const F&); void start();
};
template <class ActionSpec> using ActionServerBase = ActionServer<ActionSpec>;
}
