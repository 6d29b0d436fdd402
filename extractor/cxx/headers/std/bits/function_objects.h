// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/utility.h>
namespace std {
template <class T = void> struct less { typedef T first_argument_type; typedef T second_argument_type; typedef bool result_type;
  bool operator()(const T&, const T&) const; };
template <> struct less<void> { template <class A, class B> bool operator()(const A&, const B&) const; };
template <class T = void> struct greater : less<T> {};
template <class T = void> struct less_equal : less<T> {};
template <class T = void> struct greater_equal : less<T> {};
template <class T = void> struct equal_to : less<T> {};
template <class T = void> struct not_equal_to : less<T> {};
template <class T = void> struct logical_and : less<T> {};
template <class T = void> struct logical_or : less<T> {};
template <class T = void> struct plus { typedef T result_type; T operator()(const T&, const T&) const; };
template <> struct plus<void> { template <class A, class B> auto operator()(const A& a, const B& b) const -> decltype(a + b); };
template <class T = void> struct minus : plus<T> {};
template <class T = void> struct multiplies : plus<T> {};
template <class T = void> struct divides : plus<T> {};
template <class T = void> struct modulus : plus<T> {};
template <class T = void> struct bit_and : plus<T> {};
template <class T = void> struct bit_or : plus<T> {};
template <class T = void> struct bit_xor : plus<T> {};
template <class T = void> struct negate { T operator()(const T&) const; };
template <class T = void> struct logical_not { bool operator()(const T&) const; };
}
