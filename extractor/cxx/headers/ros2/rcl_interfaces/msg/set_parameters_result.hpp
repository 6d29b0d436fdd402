// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rosarch/message_prelude.hpp>

namespace rcl_interfaces { namespace msg {
struct SetParametersResult_ {
  ROSARCH_MESSAGE(SetParametersResult_)
  typedef bool _successful_type;
  _successful_type successful;
  typedef std::string _reason_type;
  _reason_type reason;
};
typedef SetParametersResult_ SetParametersResult;
}}
