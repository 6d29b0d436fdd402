// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rosarch/message_prelude.hpp>
#include <rcl_interfaces/msg/parameter_value.hpp>

namespace rcl_interfaces { namespace msg {
struct Parameter_ {
  ROSARCH_MESSAGE(Parameter_)
  typedef std::string _name_type;
  _name_type name;
  typedef ::rcl_interfaces::msg::ParameterValue_ _value_type;
  _value_type value;
};
typedef Parameter_ Parameter;
}}
