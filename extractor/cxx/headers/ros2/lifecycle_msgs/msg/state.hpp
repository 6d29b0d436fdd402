// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rosarch/message_prelude.hpp>

namespace lifecycle_msgs { namespace msg {
struct State_ {
  ROSARCH_MESSAGE(State_)
  static constexpr uint8_t PRIMARY_STATE_UNKNOWN = 0;
  static constexpr uint8_t PRIMARY_STATE_UNCONFIGURED = 1;
  static constexpr uint8_t PRIMARY_STATE_INACTIVE = 2;
  static constexpr uint8_t PRIMARY_STATE_ACTIVE = 3;
  static constexpr uint8_t PRIMARY_STATE_FINALIZED = 4;
  static constexpr uint8_t TRANSITION_STATE_CONFIGURING = 10;
  static constexpr uint8_t TRANSITION_STATE_CLEANINGUP = 11;
  static constexpr uint8_t TRANSITION_STATE_SHUTTINGDOWN = 12;
  static constexpr uint8_t TRANSITION_STATE_ACTIVATING = 13;
  static constexpr uint8_t TRANSITION_STATE_DEACTIVATING = 14;
  static constexpr uint8_t TRANSITION_STATE_ERRORPROCESSING = 15;
  typedef uint8_t _id_type;
  _id_type id;
  typedef std::string _label_type;
  _label_type label;
};
typedef State_ State;
}}
