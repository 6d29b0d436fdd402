// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <exception>
#include <type_traits>
#include <utility>
namespace tl {
template <class E> class unexpected {
public:
  unexpected() = delete;
  template <class U = E> constexpr explicit unexpected(U&&);
  const E& value() const; E& value();
};
template <class E> unexpected(E) -> unexpected<E>;
template <class E> unexpected<typename std::decay<E>::type> make_unexpected(E&&);
template <class E> class bad_expected_access : public std::exception { public: E& error(); const E& error() const; };
struct unexpect_t {};
constexpr unexpect_t unexpect{};

template <class T, class E> class expected {
public:
  typedef T value_type; typedef E error_type; typedef unexpected<E> unexpected_type;
  expected(); expected(const expected&); expected(expected&&);
  template <class U, class = typename std::enable_if<std::is_constructible<T, U>::value && !std::is_same<typename std::decay<U>::type,
    expected>::value>::type> expected(U&&);
  template <class G> expected(const unexpected<G>&);
  template <class... A> explicit expected(std::in_place_t, A&&...); template <class... A> explicit expected(unexpect_t, A&&...);
  expected& operator=(const expected&); expected& operator=(expected&&);
  template <class U> expected& operator=(U&&); template <class G> expected& operator=(const unexpected<G>&);
  T& operator*(); const T& operator*() const; T* operator->(); const T* operator->() const;
  T& value(); const T& value() const; template <class U> T value_or(U&&) const; E& error(); const E& error() const;
  bool has_value() const noexcept; explicit operator bool() const noexcept;
  template <class... A> T& emplace(A&&...); void swap(expected&);
  template <class F> std::invoke_result_t<F, T&> and_then(F&&) const;
  template <class F> expected<std::invoke_result_t<F, T&>, E> map(F&&) const;
  template <class F> expected<std::invoke_result_t<F, T&>, E> transform(F&&) const;
  template <class F> expected<T, std::invoke_result_t<F, E&>> map_error(F&&) const;
  template <class F> expected or_else(F&&) const;
};
template <class E> class expected<void, E> {
public:
  typedef void value_type; typedef E error_type; typedef unexpected<E> unexpected_type;
  expected(); template <class G> expected(const unexpected<G>&); template <class... A> explicit expected(unexpect_t, A&&...);
  template <class G> expected& operator=(const unexpected<G>&);
  void operator*() const; void value() const; E& error(); const E& error() const;
  bool has_value() const noexcept; explicit operator bool() const noexcept; void emplace();
  template <class F> std::invoke_result_t<F> and_then(F&&) const;
  template <class F> expected<std::invoke_result_t<F>, E> map(F&&) const;
  template <class F> expected<void, std::invoke_result_t<F, E&>> map_error(F&&) const;
  template <class F> expected or_else(F&&) const;
};
template <class T, class E, class U> bool operator==(const expected<T, E>&, const U&);
template <class T, class E, class U> bool operator!=(const expected<T, E>&, const U&);
}
