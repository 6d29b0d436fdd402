// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rosarch/message_prelude.hpp>
#include <unique_identifier_msgs/msg/uuid.hpp>
#include <builtin_interfaces/msg/time.hpp>

namespace action_msgs { namespace msg {
struct GoalInfo_ {
  ROSARCH_MESSAGE(GoalInfo_)
  typedef ::unique_identifier_msgs::msg::UUID_ _goal_id_type;
  _goal_id_type goal_id;
  typedef ::builtin_interfaces::msg::Time_ _stamp_type;
  _stamp_type stamp;
};
typedef GoalInfo_ GoalInfo;
}}
