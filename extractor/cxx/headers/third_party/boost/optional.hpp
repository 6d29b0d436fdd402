// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/utility.h>
namespace boost {
struct none_t {};
const none_t none = {};
template <class T> class optional {
public:
  typedef T value_type;
  optional(); optional(none_t); optional(const optional&);
  template <class U, class = typename std::enable_if<std::is_constructible<T, U>::value && !std::is_same<typename std::decay<U>::type,
    optional>::value>::type> optional(U&&);
  optional(bool, const T&);
  optional& operator=(const optional&); optional& operator=(none_t); template <class U> optional& operator=(U&&);
  T& operator*() const; T* operator->() const; T& get() const; T& value() const; T* get_ptr() const;
  template <class U> T value_or(const U&) const; template <class U> T get_value_or(const U&) const;
  bool is_initialized() const; bool has_value() const; explicit operator bool() const; bool operator!() const; void reset();
    template <class U> void reset(const U&); template <class... A> void emplace(A&&...);
};
template <class T> class optional<T&> {
public:
  optional(); optional(none_t); optional(T&); T& operator*() const; T* operator->() const; T& get() const; explicit operator bool() const;
    bool operator!() const;
};
template <class T> optional<T> make_optional(const T&);
template <class T, class U> bool operator==(const optional<T>&, const U&);
template <class T, class U> bool operator!=(const optional<T>&, const U&);
}
