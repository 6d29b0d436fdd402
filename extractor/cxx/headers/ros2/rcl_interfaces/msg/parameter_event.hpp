// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rosarch/message_prelude.hpp>
#include <builtin_interfaces/msg/time.hpp>
#include <rcl_interfaces/msg/parameter.hpp>

namespace rcl_interfaces { namespace msg {
struct ParameterEvent_ {
  ROSARCH_MESSAGE(ParameterEvent_)
  typedef ::builtin_interfaces::msg::Time_ _stamp_type;
  _stamp_type stamp;
  typedef std::string _node_type;
  _node_type node;
  typedef std::vector<::rcl_interfaces::msg::Parameter_> _new_parameters_type;
  _new_parameters_type new_parameters;
  typedef std::vector<::rcl_interfaces::msg::Parameter_> _changed_parameters_type;
  _changed_parameters_type changed_parameters;
  typedef std::vector<::rcl_interfaces::msg::Parameter_> _deleted_parameters_type;
  _deleted_parameters_type deleted_parameters;
};
typedef ParameterEvent_ ParameterEvent;
}}
