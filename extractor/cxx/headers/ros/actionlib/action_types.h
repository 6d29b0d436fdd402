// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/ros.h>
#include <actionlib_msgs/GoalID.h>
#include <actionlib_msgs/GoalStatus.h>
#include <actionlib_msgs/GoalStatusArray.h>
#include <rosarch/any.h>
namespace actionlib {
// The messages of an action; `any` where the action type is not known.
template <class A, class = void> struct rosarch_goal { typedef rosarch::any type; };
template <class A> struct rosarch_goal<A, std::void_t<decltype(A::action_goal.goal)>> { typedef decltype(A::action_goal.goal) type; };
template <class A, class = void> struct rosarch_result { typedef rosarch::any type; };
template <class A> struct rosarch_result<A,
  std::void_t<decltype(A::action_result.result)>> { typedef decltype(A::action_result.result) type; };
template <class A, class = void> struct rosarch_feedback { typedef rosarch::any type; };
template <class A> struct rosarch_feedback<A,
  std::void_t<decltype(A::action_feedback.feedback)>> { typedef decltype(A::action_feedback.feedback) type; };
#define ACTION_DEFINITION(ActionSpec) \
  typedef ActionSpec Action; \
  typedef typename ::actionlib::rosarch_goal<ActionSpec>::type Goal; \
  typedef typename ::actionlib::rosarch_result<ActionSpec>::type Result; \
  typedef typename ::actionlib::rosarch_feedback<ActionSpec>::type Feedback; \
  typedef boost::shared_ptr<const Goal> GoalConstPtr; \
  typedef boost::shared_ptr<const Result> ResultConstPtr; \
  typedef boost::shared_ptr<const Feedback> FeedbackConstPtr;
}
