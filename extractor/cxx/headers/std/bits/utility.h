// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
// move, forward, swap, pair: what everything else needs of <utility>.
#include <type_traits>
#include <initializer_list>
namespace std {
template <class T> constexpr typename remove_reference<T>::type&& move(T&& t) noexcept { return static_cast<typename
  remove_reference<T>::type&&>(t); }
template <class T> constexpr T&& forward(typename remove_reference<T>::type& t) noexcept { return static_cast<T&&>(t); }
template <class T> constexpr T&& forward(typename remove_reference<T>::type&& t) noexcept { return static_cast<T&&>(t); }
template <class T> T&& move_if_noexcept(T&) noexcept;
template <class T> void swap(T&, T&);
template <class T, size_t n> void swap(T (&)[n], T (&)[n]);
template <class T, class U = T> T exchange(T&, U&&);
template <class T> constexpr const T& as_const(T& t) noexcept { return t; }
template <class T> T* addressof(T&) noexcept;
struct piecewise_construct_t {};
constexpr piecewise_construct_t piecewise_construct{};
struct in_place_t {};
constexpr in_place_t in_place{};
template <class... T> class tuple;
template <class A, class B> struct pair {
  typedef A first_type;
  typedef B second_type;
  A first;
  B second;
  constexpr pair() : first(), second() {}
  constexpr pair(const A& a, const B& b) : first(a), second(b) {}
  template <class U, class V> constexpr pair(U&& u, V&& v) : first(static_cast<U&&>(u)), second(static_cast<V&&>(v)) {}
  template <class U, class V> constexpr pair(const pair<U, V>& p) : first(p.first), second(p.second) {}
  template <class... U, class... V> pair(piecewise_construct_t, tuple<U...>, tuple<V...>);
  pair(const pair&) = default;
  pair(pair&&) = default;
  pair& operator=(const pair&);
  template <class U, class V> pair& operator=(const pair<U, V>&);
  void swap(pair&);
};
template <class A, class B> pair(A, B) -> pair<A, B>;
template <class A, class B> constexpr pair<typename decay<A>::type, typename decay<B>::type> make_pair(A&& a, B&& b) {
  return pair<typename decay<A>::type, typename decay<B>::type>(static_cast<A&&>(a), static_cast<B&&>(b));
}
template <class A, class B> bool operator==(const pair<A, B>&, const pair<A, B>&);
template <class A, class B> bool operator!=(const pair<A, B>&, const pair<A, B>&);
template <class A, class B> bool operator<(const pair<A, B>&, const pair<A, B>&);
template <class A, class B> bool operator>(const pair<A, B>&, const pair<A, B>&);
template <class A, class B> bool operator<=(const pair<A, B>&, const pair<A, B>&);
template <class A, class B> bool operator>=(const pair<A, B>&, const pair<A, B>&);
template <class T> struct tuple_size;
template <size_t i, class T> struct tuple_element;
template <class T> struct tuple_size<const T> : tuple_size<T> {};
template <size_t i, class T> struct tuple_element<i, const T> { typedef const typename tuple_element<i, T>::type type; };
template <class A, class B> struct tuple_size<pair<A, B>> : integral_constant<size_t, 2> {};
template <class A, class B> struct tuple_element<0, pair<A, B>> { typedef A type; };
template <class A, class B> struct tuple_element<1, pair<A, B>> { typedef B type; };
template <size_t i, class T> using tuple_element_t = typename tuple_element<i, T>::type;
template <size_t i, class A, class B> typename tuple_element<i, pair<A, B>>::type& get(pair<A, B>&) noexcept;
template <size_t i, class A, class B> const typename tuple_element<i, pair<A, B>>::type& get(const pair<A, B>&) noexcept;
template <size_t i, class A, class B> typename tuple_element<i, pair<A, B>>::type&& get(pair<A, B>&&) noexcept;
template <size_t i, class U> rosarch_if_unknown<U, rosarch_healed::unknown&> get(const U&);
template <class T> struct hash { size_t operator()(const T&) const; };
}
