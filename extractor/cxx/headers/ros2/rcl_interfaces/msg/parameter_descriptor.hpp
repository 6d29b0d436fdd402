// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rosarch/message_prelude.hpp>
#include <rcl_interfaces/msg/floating_point_range.hpp>
#include <rcl_interfaces/msg/integer_range.hpp>

namespace rcl_interfaces { namespace msg {
struct ParameterDescriptor_ {
  ROSARCH_MESSAGE(ParameterDescriptor_)
  typedef std::string _name_type;
  _name_type name;
  typedef uint8_t _type_type;
  _type_type type;
  typedef std::string _description_type;
  _description_type description;
  typedef std::string _additional_constraints_type;
  _additional_constraints_type additional_constraints;
  typedef bool _read_only_type;
  _read_only_type read_only;
  typedef bool _dynamic_typing_type;
  _dynamic_typing_type dynamic_typing;
  typedef std::vector<::rcl_interfaces::msg::FloatingPointRange_> _floating_point_range_type;
  _floating_point_range_type floating_point_range;
  typedef std::vector<::rcl_interfaces::msg::IntegerRange_> _integer_range_type;
  _integer_range_type integer_range;
};
typedef ParameterDescriptor_ ParameterDescriptor;
}}
