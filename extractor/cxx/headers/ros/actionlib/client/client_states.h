// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
namespace actionlib {
#define ROSARCH_STATE(Name, ...) \
  class Name { \
  public: \
    enum StateEnum { __VA_ARGS__ }; StateEnum state_; std::string text_; \
    Name(const StateEnum&, const std::string& = std::string()); \
    bool operator==(const Name&) const; bool operator==(const StateEnum&) const; bool operator!=(const Name&) const; \
      bool operator!=(const StateEnum&) const; \
    bool isDone() const; std::string toString() const; std::string getText() const; \
  };
ROSARCH_STATE(SimpleClientGoalState, PENDING, ACTIVE, RECALLED, REJECTED, PREEMPTED, ABORTED, SUCCEEDED, LOST)
ROSARCH_STATE(TerminalState, RECALLED, REJECTED, PREEMPTED, ABORTED, SUCCEEDED, LOST)
ROSARCH_STATE(CommState, WAITING_FOR_GOAL_ACK, PENDING, ACTIVE, WAITING_FOR_RESULT, WAITING_FOR_CANCEL_ACK, RECALLING, PREEMPTING, DONE)
ROSARCH_STATE(SimpleGoalState, PENDING, ACTIVE, DONE)
#undef ROSARCH_STATE
}
