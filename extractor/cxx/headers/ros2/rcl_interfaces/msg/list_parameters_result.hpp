// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rosarch/message_prelude.hpp>

namespace rcl_interfaces { namespace msg {
struct ListParametersResult_ {
  ROSARCH_MESSAGE(ListParametersResult_)
  typedef std::vector<std::string> _names_type;
  _names_type names;
  typedef std::vector<std::string> _prefixes_type;
  _prefixes_type prefixes;
};
typedef ListParametersResult_ ListParametersResult;
}}
