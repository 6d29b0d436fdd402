// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
namespace boost {
class format {
public:
  explicit format(const char*); explicit format(const std::string&);
  template <class T> format& operator%(const T&);
  std::string str() const; operator std::string() const; void clear();
};
std::string str(const format&);
namespace io { class format_error {}; }
}
