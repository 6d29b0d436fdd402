// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
// What values of unknown type are made of; the header that healing writes includes this one (see heal.py).
#ifndef ROSARCH_UNKNOWN_MEMBERS
#define ROSARCH_UNKNOWN_MEMBERS
#endif
#define ROSARCH_NUMBERED(name) ROSARCH_NUMBERED_(name, __COUNTER__)
#define ROSARCH_NUMBERED_(name, number) ROSARCH_JOINED(name, number)
#define ROSARCH_JOINED(name, number) name##number
namespace rosarch_healed {

struct unknown;

/// The address of a value of unknown type: that of whatever is asked for.
struct address {
  template <typename T> operator T*() const;
  unknown* operator->() const;
  unknown& operator*() const;
  explicit operator bool() const;
};

/// A value of unknown type. Only `operator T&`: a second conversion, to `T`, would make most uses ambiguous.
struct unknown {
  unknown();
  unknown(const unknown&);
  template <typename A> explicit unknown(A&&);
  template <typename A, typename B, typename... C> unknown(A&&, B&&, C&&...);
  template <typename T> operator T&() const;
  explicit operator int() const;  // for switch
  template <typename... A> unknown& operator()(A&&...) const;
  template <typename A> unknown& operator[](A&&) const;
  unknown* operator->() const;
  unknown& operator*() const;
  address operator&() const;
  unknown& operator=(const unknown&);
  template <typename A> unknown& operator=(A&&);
  unknown& operator++();
  unknown& operator++(int);
  unknown& operator--();
  unknown& operator--(int);
  unknown& operator-() const;
  unknown& operator~() const;
  bool operator!() const;
  unknown* begin() const;
  unknown* end() const;
  ROSARCH_UNKNOWN_MEMBERS
};

/// A value of a type that a class calls by a name of its own: parameters and results are declared with it, so all else converts to it.
struct unknown_named : unknown {
  unknown_named();
  template <typename A, typename... B> unknown_named(A&&, B&&...);
  template <typename A> unknown_named& operator=(A&&);
};

template <bool, typename T> struct when {};
template <typename T> struct when<true, T> { typedef T type; };
template <typename T> struct plain { typedef T type; };
template <typename T> struct plain<T&> { typedef T type; };
template <typename T> struct plain<const T&> { typedef T type; };
template <typename T> constexpr bool healed = __is_base_of(unknown, typename plain<T>::type);
template <typename A, typename B, typename R> using either = typename when<healed<A> || healed<B>, R>::type;

#define ROSARCH_OPERATOR(op, result) template <typename A, typename B> either<A, B, result> operator op(const A&, const B&);
ROSARCH_OPERATOR(+, unknown&)
ROSARCH_OPERATOR(-, unknown&)
ROSARCH_OPERATOR(*, unknown&)
ROSARCH_OPERATOR(/, unknown&)
ROSARCH_OPERATOR(%, unknown&)
ROSARCH_OPERATOR(&, unknown&)
ROSARCH_OPERATOR(|, unknown&)
ROSARCH_OPERATOR(^, unknown&)
ROSARCH_OPERATOR(==, bool)
ROSARCH_OPERATOR(!=, bool)
ROSARCH_OPERATOR(<, bool)
ROSARCH_OPERATOR(>, bool)
ROSARCH_OPERATOR(<=, bool)
ROSARCH_OPERATOR(>=, bool)
#undef ROSARCH_OPERATOR
template <typename A, typename B> either<A, B, A&> operator+=(A&, const B&);
template <typename A, typename B> either<A, B, A&> operator-=(A&, const B&);
template <typename A, typename B> either<A, B, A&> operator*=(A&, const B&);
template <typename A, typename B> either<A, B, A&> operator/=(A&, const B&);
template <typename A, typename B> either<A, B, A&> operator%=(A&, const B&);
template <typename A, typename B> either<A, B, A&> operator|=(A&, const B&);
template <typename A, typename B> either<A, B, A&> operator&=(A&, const B&);
template <typename A, typename B> either<A, B, A&> operator^=(A&, const B&);
template <typename A, typename B> either<A, B, unknown&> operator,(const A&, const B&);
template <typename A, typename B> either<A, B, A&> operator<<(A&&, const B&);
template <typename A, typename B> either<A, B, A&> operator>>(A&&, B&&);

}  // namespace rosarch_healed
