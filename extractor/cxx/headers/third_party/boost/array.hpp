// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/iterator.h>
namespace boost {
template <class T, std::size_t n> class array {
public:
  T elems[n ? n : 1];
  typedef T value_type; typedef T* iterator; typedef const T* const_iterator; typedef T& reference; typedef const T& const_reference;
    typedef std::size_t size_type; typedef std::ptrdiff_t difference_type;
  enum { static_size = n };
  T* begin(); const T* begin() const; T* end(); const T* end() const; const T* cbegin() const; const T* cend() const;
  std::reverse_iterator<T*> rbegin(); std::reverse_iterator<T*> rend();
  T& operator[](std::size_t); const T& operator[](std::size_t) const; T& at(std::size_t); const T& at(std::size_t) const;
  T& front(); const T& front() const; T& back(); const T& back() const; T* data(); const T* data() const; T* c_array();
  static std::size_t size(); static bool empty(); static std::size_t max_size(); void assign(const T&); void fill(const T&);
    void swap(array&);
  template <class U> array& operator=(const array<U, n>&);
};
template <class T, std::size_t n> bool operator==(const array<T, n>&, const array<T, n>&);
template <class T, std::size_t n> bool operator!=(const array<T, n>&, const array<T, n>&);
}
