// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <regex>
namespace boost { using std::regex; using std::smatch; using std::cmatch; using std::ssub_match; using std::regex_match;
  using std::regex_search; using std::regex_replace; using std::regex_error; using std::sregex_iterator; using std::sregex_token_iterator; }
