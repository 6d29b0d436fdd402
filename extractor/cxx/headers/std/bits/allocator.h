// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/utility.h>
#include <new>
namespace std {
template <class T> class allocator {
public:
  typedef T value_type;
  typedef T* pointer;
  typedef const T* const_pointer;
  typedef size_t size_type;
  typedef ptrdiff_t difference_type;
  template <class U> struct rebind { typedef allocator<U> other; };
  allocator() noexcept;
  template <class U> allocator(const allocator<U>&) noexcept;
  T* allocate(size_t, const void* = nullptr);
  void deallocate(T*, size_t);
};
template <class A> struct allocator_traits {
  typedef typename A::value_type value_type;
  typedef value_type* pointer;
  typedef size_t size_type;
  template <class U> using rebind_alloc = typename A::template rebind<U>::other;
};
}
