// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rosarch/message_prelude.hpp>

namespace unique_identifier_msgs { namespace msg {
struct UUID_ {
  ROSARCH_MESSAGE(UUID_)
  typedef std::array<uint8_t, 16> _uuid_type;
  _uuid_type uuid;
};
typedef UUID_ UUID;
}}
