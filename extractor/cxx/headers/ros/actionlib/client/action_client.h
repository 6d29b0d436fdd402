// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <actionlib/client/client_states.h>
#include <actionlib/action_types.h>
namespace actionlib {
template <class ActionSpec> class ClientGoalHandle { public: ACTION_DEFINITION(ActionSpec) bool isExpired() const; void reset();
  CommState getCommState() const; TerminalState getTerminalState() const; ResultConstPtr getResult() const; void resend(); void cancel();
  bool operator==(const ClientGoalHandle&) const; bool operator!=(const ClientGoalHandle&) const; };
template <class ActionSpec> class ActionClient { public: ACTION_DEFINITION(ActionSpec) typedef ClientGoalHandle<ActionSpec> GoalHandle;
  template <class... A> ActionClient(const A&...); template <class G, class... A> GoalHandle sendGoal(const G& goal, const A&...);
  void cancelAllGoals(); void cancelGoalsAtAndBeforeTime(const ros::Time&);
  bool waitForActionServerToStart(const ros::Duration& = ros::Duration(0, 0)); bool isServerConnected(); };
}
