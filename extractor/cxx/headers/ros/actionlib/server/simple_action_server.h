// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <actionlib/action_types.h>
namespace actionlib {
template <class ActionSpec> class SimpleActionServer {
public:
  ACTION_DEFINITION(ActionSpec)
  typedef boost::function<void(const GoalConstPtr&)> ExecuteCallback;
  // ([node handle,] name[, execute callback][, auto start])
  template <class... A> SimpleActionServer(const ros::NodeHandle&, const std::string& name, const A&...);
  template <class... A> SimpleActionServer(const std::string& name, const A&...);
  ~SimpleActionServer();
  GoalConstPtr acceptNewGoal();
  bool isNewGoalAvailable(); bool isPreemptRequested(); bool isActive();
  void setSucceeded(const Result& = Result(), const std::string& = ""); void setAborted(const Result& = Result(), const std::string& = "");
    void setPreempted(const Result& = Result(), const std::string& = "");
  template <class F> void publishFeedback(const F& feedback);
  template <class F> void registerGoalCallback(const F& callback); template <class F> void registerPreemptCallback(const F& callback);
  void start(); void shutdown();
};
}
