// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <system_error>
namespace boost { namespace system {
using std::error_code; using std::error_category; using std::system_category; using std::generic_category;
class system_error : public std::runtime_error { public: system_error(const error_code&);
  system_error(const error_code&, const std::string&); error_code code() const; };
namespace errc { enum errc_t { success, operation_canceled, no_such_file_or_directory }; }
} }
