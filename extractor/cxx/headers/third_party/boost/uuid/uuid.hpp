// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
namespace boost { namespace uuids {
struct uuid { unsigned char data[16]; bool is_nil() const; static std::size_t size(); unsigned char* begin(); unsigned char* end();
  bool operator==(const uuid&) const; bool operator!=(const uuid&) const; bool operator<(const uuid&) const; };
struct random_generator { uuid operator()() const; }; struct string_generator { uuid operator()(const std::string&) const; };
  struct nil_generator { uuid operator()() const; }; std::string to_string(const uuid&);
} }
