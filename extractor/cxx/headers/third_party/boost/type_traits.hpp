// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <type_traits>
namespace boost {
using std::is_same; using std::is_base_of; using std::is_convertible; using std::is_integral; using std::is_floating_point;
  using std::is_arithmetic; using std::is_enum; using std::is_pointer; using std::remove_const; using std::remove_reference;
  using std::remove_cv; using std::true_type; using std::false_type; using std::add_const; using std::is_class; using std::is_abstract; using std::remove_pointer;
  using std::is_void; using std::integral_constant; using std::is_reference; using std::is_function; using std::is_scalar;
template <class C, class T = void> struct enable_if : std::enable_if<C::value, T> {};
  template <class C, class T = void> struct disable_if : std::enable_if<!C::value, T> {};
  template <bool b, class T = void> struct enable_if_c : std::enable_if<b, T> {};
  template <bool b, class T = void> struct disable_if_c : std::enable_if<!b, T> {};
namespace mpl { template <bool b> using bool_ = std::integral_constant<bool, b>; typedef std::true_type true_;
  typedef std::false_type false_; template <int n> using int_ = std::integral_constant<int, n>; template <class... T> struct vector {};
  template <class T> struct identity { typedef T type; }; template <class C, class A, class B> using if_ = std::conditional<C::value, A, B>;
  template <bool c, class A, class B> using if_c = std::conditional<c, A, B>; }
}
