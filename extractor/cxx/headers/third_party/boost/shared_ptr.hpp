// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cassert>
#include <climits>
#include <cstddef>
#include <cstring>
#include <memory>
#include <bits/utility.h>
#include <bits/memory.h>
namespace boost {
template <class T> class weak_ptr;
template <class T> class shared_ptr {
public:
  typedef typename std::rosarch_element<T>::type element_type;
  typedef T value_type;
  shared_ptr(std::nullptr_t = nullptr);
  template <class U, class = typename std::enable_if<std::is_convertible<U*, element_type*>::value>::type> explicit shared_ptr(U*);
  template <class U, class D, class... A> shared_ptr(U, D, A...);
  shared_ptr(const shared_ptr&);
  template <class U, class = typename std::enable_if<std::is_convertible<U*, T*>::value>::type> shared_ptr(const shared_ptr<U>&);
  template <class U> shared_ptr(const shared_ptr<U>&, element_type*);
  template <class U> explicit shared_ptr(const weak_ptr<U>&);
  template <class U, class D> shared_ptr(std::unique_ptr<U, D>&&);
  ~shared_ptr();
  shared_ptr& operator=(const shared_ptr&);
  template <class U> shared_ptr& operator=(const shared_ptr<U>&);
  shared_ptr& operator=(std::nullptr_t);
  typename std::add_lvalue_reference<element_type>::type operator*() const;
  element_type* operator->() const;
  element_type* get() const;
  template <class I> typename std::add_lvalue_reference<element_type>::type operator[](I) const;
  void reset();
  template <class U, class... X> void reset(U, X...);
  void swap(shared_ptr&);
  long use_count() const;
  bool unique() const;
  explicit operator bool() const;
  bool operator!() const;
};
template <class T, class U> bool operator==(const shared_ptr<T>&, const shared_ptr<U>&);
template <class T, class U> bool operator!=(const shared_ptr<T>&, const shared_ptr<U>&);
template <class T, class U> bool operator<(const shared_ptr<T>&, const shared_ptr<U>&);
// Also matches NULL and 0, which old code compares with.
template <class T> bool operator==(const shared_ptr<T>&, std::nullptr_t);
template <class T> bool operator!=(const shared_ptr<T>&, std::nullptr_t);
template <class T> bool operator==(const shared_ptr<T>&, const void*);
template <class T> bool operator!=(const shared_ptr<T>&, const void*);
template <class T> class weak_ptr {
public:
  typedef T element_type;
  weak_ptr();
  weak_ptr(const weak_ptr&);
  template <class U> weak_ptr(const weak_ptr<U>&);
  template <class U> weak_ptr(const shared_ptr<U>&);
  weak_ptr& operator=(const weak_ptr&);
  template <class U> weak_ptr& operator=(const shared_ptr<U>&);
  shared_ptr<T> lock() const;
  bool expired() const;
  long use_count() const;
  void reset();
};
template <class T> bool operator<(const weak_ptr<T>&, const weak_ptr<T>&);
template <class T> class enable_shared_from_this {
public:
  shared_ptr<T> shared_from_this();
  shared_ptr<const T> shared_from_this() const;
};
template <class T> class shared_array {
public:
  shared_array(T* = nullptr);
  T& operator[](std::ptrdiff_t) const; T* get() const; void reset(T* = nullptr); explicit operator bool() const; long use_count() const;
};
template <class T> class scoped_ptr {
public:
  typedef T element_type;
  explicit scoped_ptr(T* = nullptr);
  ~scoped_ptr();
  T& operator*() const; T* operator->() const; T* get() const; void reset(T* = nullptr); void swap(scoped_ptr&);
  explicit operator bool() const; bool operator!() const;
};
template <class T> class scoped_array { public: explicit scoped_array(T* = nullptr); T& operator[](std::ptrdiff_t) const; T* get() const;
  void reset(T* = nullptr); explicit operator bool() const; };
template <class T, class... A> shared_ptr<T> make_shared(A&&...);
template <class T, class Alloc, class... A> shared_ptr<T> allocate_shared(const Alloc&, A&&...);
template <class T, class U> shared_ptr<T> static_pointer_cast(const shared_ptr<U>&);
template <class T, class U> shared_ptr<T> dynamic_pointer_cast(const shared_ptr<U>&);
template <class T, class U> shared_ptr<T> const_pointer_cast(const shared_ptr<U>&);
template <class T, class U> shared_ptr<T> reinterpret_pointer_cast(const shared_ptr<U>&);
template <class T> T* get_pointer(const shared_ptr<T>&);
}
