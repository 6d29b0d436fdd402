// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/sequence.h>
namespace boost {
using std::rosarch_iterator; using std::initializer_list; using std::rosarch_if_iterator;
template <class T, class A = std::allocator<T>> class circular_buffer {
public:
  ROSARCH_SEQUENCE(circular_buffer, T, A)
  T& operator[](std::size_t); const T& operator[](std::size_t) const; T& at(std::size_t); const T& at(std::size_t) const;
  void push_front(const T&); void pop_front(); bool full() const; std::size_t capacity() const; void set_capacity(std::size_t);
    void rset_capacity(std::size_t); std::size_t reserve() const; T* linearize(); void rotate(const_iterator);
};
}
