// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>
#include <rosarch/any.h>
namespace boost {
namespace algorithm {
enum token_compress_mode_type { token_compress_on, token_compress_off };
struct rosarch_predicate { template <class C> bool operator()(C) const; rosarch_predicate operator!() const; };
template <class S> rosarch_predicate is_any_of(const S&);
rosarch_predicate is_space(); rosarch_predicate is_digit(); rosarch_predicate is_alpha(); rosarch_predicate is_alnum();
  rosarch_predicate is_upper(); rosarch_predicate is_lower(); rosarch_predicate is_punct();
rosarch_predicate operator||(rosarch_predicate, rosarch_predicate); rosarch_predicate operator&&(rosarch_predicate, rosarch_predicate);
template <class C, class S, class P> C& split(C&, S&&, P, token_compress_mode_type = token_compress_off);
template <class C, class S, class P> C& iter_split(C&, S&&, P);
template <class C, class S> std::string join(const C&, const S&);
#define ROSARCH_STRING_CHANGE(name) template <class S, class... X> void name(S&, const X&...); \
  template <class S, class... X> S name##_copy(const S&, const X&...);
ROSARCH_STRING_CHANGE(trim) ROSARCH_STRING_CHANGE(trim_left) ROSARCH_STRING_CHANGE(trim_right) ROSARCH_STRING_CHANGE(trim_if)
  ROSARCH_STRING_CHANGE(trim_left_if)
ROSARCH_STRING_CHANGE(trim_right_if) ROSARCH_STRING_CHANGE(to_lower) ROSARCH_STRING_CHANGE(to_upper) ROSARCH_STRING_CHANGE(replace_all)
ROSARCH_STRING_CHANGE(replace_first) ROSARCH_STRING_CHANGE(replace_last) ROSARCH_STRING_CHANGE(erase_all)
  ROSARCH_STRING_CHANGE(erase_first) ROSARCH_STRING_CHANGE(erase_last)
#undef ROSARCH_STRING_CHANGE
#define ROSARCH_STRING_TEST(name) template <class S, class... X> bool name(const S&, const X&...);
ROSARCH_STRING_TEST(starts_with) ROSARCH_STRING_TEST(istarts_with) ROSARCH_STRING_TEST(ends_with) ROSARCH_STRING_TEST(iends_with)
  ROSARCH_STRING_TEST(contains)
ROSARCH_STRING_TEST(icontains) ROSARCH_STRING_TEST(equals) ROSARCH_STRING_TEST(iequals) ROSARCH_STRING_TEST(all)
#undef ROSARCH_STRING_TEST
}
using namespace algorithm;
using algorithm::is_any_of;
using algorithm::split;
using algorithm::join;
}
