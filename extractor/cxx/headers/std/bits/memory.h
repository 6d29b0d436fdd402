// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/utility.h>
namespace std {
template <class T> struct default_delete { void operator()(T*) const; };
template <class T> struct default_delete<T[]> { void operator()(T*) const; };
template <class T, class D = default_delete<T>> class unique_ptr {
public:
  typedef T element_type;
  typedef T* pointer;
  typedef D deleter_type;
  unique_ptr(nullptr_t = nullptr) noexcept;
  explicit unique_ptr(T*) noexcept;
  unique_ptr(T*, const D&) noexcept;
  unique_ptr(unique_ptr&&) noexcept;
  unique_ptr(const unique_ptr&) noexcept;  // none in truth: for values of unknown type, which are given by reference
  template <class U, class E, class = typename enable_if<is_convertible<U*, T*>::value>::type> unique_ptr(unique_ptr<U, E>&&) noexcept;
  ~unique_ptr();
  unique_ptr& operator=(unique_ptr&&) noexcept;
  unique_ptr& operator=(nullptr_t) noexcept;
  template <class U> rosarch_if_unknown<U, unique_ptr&> operator=(const U&);
  template <class U, class E> unique_ptr& operator=(unique_ptr<U, E>&&) noexcept;
  T& operator*() const; T* operator->() const noexcept; T* get() const noexcept; T* release() noexcept;
  template <class U = T*> void reset(U = nullptr) noexcept;
  D& get_deleter();
  void swap(unique_ptr&) noexcept;
  explicit operator bool() const noexcept;
};
template <class T, class D> class unique_ptr<T[], D> {
public:
  typedef T element_type;
  typedef T* pointer;
  unique_ptr(nullptr_t = nullptr) noexcept;
  explicit unique_ptr(T*) noexcept;
  unique_ptr(T*, const D&) noexcept;
  unique_ptr(unique_ptr&&) noexcept;
  unique_ptr(const unique_ptr&) noexcept;  // none in truth: for values of unknown type, which are given by reference
  unique_ptr& operator=(unique_ptr&&) noexcept;
  unique_ptr& operator=(nullptr_t) noexcept;
  template <class U> rosarch_if_unknown<U, unique_ptr&> operator=(const U&);
  T& operator[](size_t) const; T* get() const noexcept; T* release() noexcept;
  template <class U = T*> void reset(U = nullptr) noexcept;
  explicit operator bool() const noexcept;
};
template <class T> class weak_ptr;
template <class T> struct rosarch_element { typedef T type; };
template <class T> struct rosarch_element<T[]> { typedef T type; };
template <class T, size_t n> struct rosarch_element<T[n]> { typedef T type; };
template <class T> class shared_ptr {
public:
  typedef typename rosarch_element<T>::type element_type;
  typedef weak_ptr<T> weak_type;
  shared_ptr(nullptr_t = nullptr) noexcept;
  ROSARCH_OF_UNKNOWN(shared_ptr)
  template <class U, class = typename enable_if<is_convertible<U*, element_type*>::value>::type> explicit shared_ptr(U*);
  template <class U, class D, class... A> shared_ptr(U, D, A...);
  shared_ptr(const shared_ptr&) noexcept;
  shared_ptr(shared_ptr&&) noexcept;
  template <class U, class = typename enable_if<is_convertible<U*, T*>::value>::type> shared_ptr(const shared_ptr<U>&) noexcept;
  template <class U> shared_ptr(const shared_ptr<U>&, element_type*) noexcept;
  template <class U> explicit shared_ptr(const weak_ptr<U>&);
  template <class U, class D> shared_ptr(unique_ptr<U, D>&&);
  ~shared_ptr();
  shared_ptr& operator=(const shared_ptr&) noexcept;
  shared_ptr& operator=(shared_ptr&&) noexcept;
  template <class U> shared_ptr& operator=(const shared_ptr<U>&) noexcept;
  template <class U, class D> shared_ptr& operator=(unique_ptr<U, D>&&);
  typename add_lvalue_reference<element_type>::type operator*() const noexcept;
  element_type* operator->() const noexcept;
  element_type* get() const noexcept;
  template <class I> typename add_lvalue_reference<element_type>::type operator[](I) const;
  void reset() noexcept;
  template <class U, class... X> void reset(U, X...);
  void swap(shared_ptr&) noexcept;
  long use_count() const noexcept;
  bool unique() const noexcept;
  explicit operator bool() const noexcept;
};
template <class T> class weak_ptr {
public:
  typedef T element_type;
  weak_ptr() noexcept;
  ROSARCH_OF_UNKNOWN(weak_ptr)
  weak_ptr(const weak_ptr&) noexcept;
  template <class U> weak_ptr(const weak_ptr<U>&) noexcept;
  template <class U> weak_ptr(const shared_ptr<U>&) noexcept;
  weak_ptr& operator=(const weak_ptr&) noexcept;
  template <class U> weak_ptr& operator=(const shared_ptr<U>&) noexcept;
  shared_ptr<T> lock() const noexcept;
  bool expired() const noexcept;
  long use_count() const noexcept;
  void reset() noexcept;
};
template <class T> class enable_shared_from_this {
public:
  shared_ptr<T> shared_from_this();
  shared_ptr<const T> shared_from_this() const;
  weak_ptr<T> weak_from_this();
};
template <class T, class... A> shared_ptr<T> make_shared(A&&...);
template <class T, class Alloc, class... A> shared_ptr<T> allocate_shared(const Alloc&, A&&...);
template <class T, class... A> unique_ptr<T> make_unique(A&&...);
template <class T, class U> shared_ptr<T> static_pointer_cast(const shared_ptr<U>&) noexcept;
template <class T, class U> shared_ptr<T> dynamic_pointer_cast(const shared_ptr<U>&) noexcept;
template <class T, class U> shared_ptr<T> const_pointer_cast(const shared_ptr<U>&) noexcept;
template <class T, class U> shared_ptr<T> reinterpret_pointer_cast(const shared_ptr<U>&) noexcept;
#define ROSARCH_POINTER(Ptr, ...) \
  template <__VA_ARGS__> bool operator==(const Ptr&, nullptr_t) noexcept; \
  template <__VA_ARGS__> bool operator==(nullptr_t, const Ptr&) noexcept; \
  template <__VA_ARGS__> bool operator!=(const Ptr&, nullptr_t) noexcept; \
  template <__VA_ARGS__> bool operator!=(nullptr_t, const Ptr&) noexcept;
#define ROSARCH_U unique_ptr<T, D>
ROSARCH_POINTER(shared_ptr<T>, class T)
ROSARCH_POINTER(ROSARCH_U, class T, class D)
#undef ROSARCH_U
#undef ROSARCH_POINTER
template <class T, class U> bool operator==(const shared_ptr<T>&, const shared_ptr<U>&) noexcept;
template <class T, class U> bool operator!=(const shared_ptr<T>&, const shared_ptr<U>&) noexcept;
template <class T, class U> bool operator<(const shared_ptr<T>&, const shared_ptr<U>&) noexcept;
template <class T, class D> bool operator==(const unique_ptr<T, D>&, const unique_ptr<T, D>&) noexcept;
template <class T, class D> bool operator!=(const unique_ptr<T, D>&, const unique_ptr<T, D>&) noexcept;
}
