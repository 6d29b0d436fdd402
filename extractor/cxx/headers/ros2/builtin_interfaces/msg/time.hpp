// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rosarch/message_prelude.hpp>

namespace builtin_interfaces { namespace msg {
struct Time_ {
  ROSARCH_MESSAGE(Time_)
  typedef int32_t _sec_type;
  _sec_type sec;
  typedef uint32_t _nanosec_type;
  _nanosec_type nanosec;
};
typedef Time_ Time;
}}
