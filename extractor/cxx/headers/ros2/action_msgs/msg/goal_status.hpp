// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rosarch/message_prelude.hpp>
#include <action_msgs/msg/goal_info.hpp>

namespace action_msgs { namespace msg {
struct GoalStatus_ {
  ROSARCH_MESSAGE(GoalStatus_)
  static constexpr int8_t STATUS_UNKNOWN = 0;
  static constexpr int8_t STATUS_ACCEPTED = 1;
  static constexpr int8_t STATUS_EXECUTING = 2;
  static constexpr int8_t STATUS_CANCELING = 3;
  static constexpr int8_t STATUS_SUCCEEDED = 4;
  static constexpr int8_t STATUS_CANCELED = 5;
  static constexpr int8_t STATUS_ABORTED = 6;
  typedef ::action_msgs::msg::GoalInfo_ _goal_info_type;
  _goal_info_type goal_info;
  typedef int8_t _status_type;
  _status_type status;
};
typedef GoalStatus_ GoalStatus;
}}
