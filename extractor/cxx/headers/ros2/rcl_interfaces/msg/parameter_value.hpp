// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rosarch/message_prelude.hpp>

namespace rcl_interfaces { namespace msg {
struct ParameterValue_ {
  ROSARCH_MESSAGE(ParameterValue_)
  typedef uint8_t _type_type;
  _type_type type;
  typedef bool _bool_value_type;
  _bool_value_type bool_value;
  typedef int64_t _integer_value_type;
  _integer_value_type integer_value;
  typedef double _double_value_type;
  _double_value_type double_value;
  typedef std::string _string_value_type;
  _string_value_type string_value;
  typedef std::vector<unsigned char> _byte_array_value_type;
  _byte_array_value_type byte_array_value;
  typedef std::vector<bool> _bool_array_value_type;
  _bool_array_value_type bool_array_value;
  typedef std::vector<int64_t> _integer_array_value_type;
  _integer_array_value_type integer_array_value;
  typedef std::vector<double> _double_array_value_type;
  _double_array_value_type double_array_value;
  typedef std::vector<std::string> _string_array_value_type;
  _string_array_value_type string_array_value;
};
typedef ParameterValue_ ParameterValue;
}}
