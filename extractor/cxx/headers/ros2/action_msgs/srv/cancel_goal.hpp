// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rosarch/message_prelude.hpp>
#include <action_msgs/msg/goal_info.hpp>

namespace action_msgs { namespace srv {
struct CancelGoal_Request_ {
  ROSARCH_MESSAGE(CancelGoal_Request_)
  typedef ::action_msgs::msg::GoalInfo_ _goal_info_type;
  _goal_info_type goal_info;
};
typedef CancelGoal_Request_ CancelGoal_Request;
struct CancelGoal_Response_ {
  ROSARCH_MESSAGE(CancelGoal_Response_)
  static constexpr int8_t ERROR_NONE = 0;
  static constexpr int8_t ERROR_REJECTED = 1;
  static constexpr int8_t ERROR_UNKNOWN_GOAL_ID = 2;
  static constexpr int8_t ERROR_GOAL_TERMINATED = 3;
  typedef int8_t _return_code_type;
  _return_code_type return_code;
  typedef std::vector<::action_msgs::msg::GoalInfo_> _goals_canceling_type;
  _goals_canceling_type goals_canceling;
};
typedef CancelGoal_Response_ CancelGoal_Response;
struct CancelGoal {
  typedef CancelGoal_Request Request;
  typedef CancelGoal_Response Response;
  ROSARCH_SERVICE(CancelGoal)
};
}}
