// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rosarch/message_prelude.hpp>

namespace rcl_interfaces { namespace msg {
struct FloatingPointRange_ {
  ROSARCH_MESSAGE(FloatingPointRange_)
  typedef double _from_value_type;
  _from_value_type from_value;
  typedef double _to_value_type;
  _to_value_type to_value;
  typedef double _step_type;
  _step_type step;
};
typedef FloatingPointRange_ FloatingPointRange;
}}
