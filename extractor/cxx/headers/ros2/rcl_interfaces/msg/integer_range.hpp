// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rosarch/message_prelude.hpp>

namespace rcl_interfaces { namespace msg {
struct IntegerRange_ {
  ROSARCH_MESSAGE(IntegerRange_)
  typedef int64_t _from_value_type;
  _from_value_type from_value;
  typedef int64_t _to_value_type;
  _to_value_type to_value;
  typedef uint64_t _step_type;
  _step_type step;
};
typedef IntegerRange_ IntegerRange;
}}
