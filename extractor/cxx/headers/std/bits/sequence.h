// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
// What vector, deque and list have in common, as macros: a base class would own the names of the shared operations,
// and a call would then refer to that base instead of `std::vector::push_back`.
#include <bits/allocator.h>
#include <bits/iterator.h>
#include <algorithm>
namespace std {
template <class I> using rosarch_if_iterator = typename iterator_traits<I>::iterator_category;
}
#define ROSARCH_CONTAINER_TYPES(Self, T) \
  typedef T value_type; \
  typedef T& reference; \
  typedef const T& const_reference; \
  typedef T* pointer; \
  typedef const T* const_pointer; \
  typedef size_t size_type; \
  typedef ptrdiff_t difference_type; \
  typedef rosarch_iterator<T, Self> iterator; \
  typedef rosarch_iterator<const T, Self> const_iterator; \
  typedef std::reverse_iterator<iterator> reverse_iterator; \
  typedef std::reverse_iterator<const_iterator> const_reverse_iterator; \
  iterator begin() noexcept; \
  const_iterator begin() const noexcept; \
  iterator end() noexcept; \
  const_iterator end() const noexcept; \
  const_iterator cbegin() const noexcept; \
  const_iterator cend() const noexcept; \
  reverse_iterator rbegin() noexcept; \
  const_reverse_iterator rbegin() const noexcept; \
  reverse_iterator rend() noexcept; \
  const_reverse_iterator rend() const noexcept; \
  const_reverse_iterator crbegin() const noexcept; \
  const_reverse_iterator crend() const noexcept; \
  bool empty() const noexcept; \
  size_t size() const noexcept; \
  size_t max_size() const noexcept; \
  void swap(Self&);
#define ROSARCH_SEQUENCE(Self, T, A) \
  ROSARCH_CONTAINER_TYPES(Self, T) \
  typedef A allocator_type; \
  Self(); \
  explicit Self(const A&); \
  explicit Self(size_t); \
  Self(size_t, const T&, const A& = A()); \
  template <class I, class = rosarch_if_iterator<I>> Self(I, I, const A& = A()); \
  Self(const Self&); \
  Self(Self&&) noexcept; \
  Self(initializer_list<T>, const A& = A()); \
  ROSARCH_OF_UNKNOWN(Self) \
  ~Self(); \
  Self& operator=(const Self&); \
  Self& operator=(Self&&) noexcept; \
  Self& operator=(initializer_list<T>); \
  void assign(size_t, const T&); \
  template <class I, class = rosarch_if_iterator<I>> void assign(I, I); \
  void assign(initializer_list<T>); \
  A get_allocator() const; \
  reference front(); \
  const_reference front() const; \
  reference back(); \
  const_reference back() const; \
  void clear() noexcept; \
  void resize(size_t); \
  void resize(size_t, const T&); \
  void push_back(const T&); \
  void push_back(T&&); \
  template <class... X> reference emplace_back(X&&...); \
  template <class... X> iterator emplace(const_iterator, X&&...); \
  void pop_back(); \
  iterator insert(const_iterator, const T&); \
  iterator insert(const_iterator, T&&); \
  iterator insert(const_iterator, size_t, const T&); \
  template <class I, class = rosarch_if_iterator<I>> iterator insert(const_iterator, I, I); \
  iterator insert(const_iterator, initializer_list<T>); \
  iterator erase(const_iterator); \
  iterator erase(const_iterator, const_iterator);
#define ROSARCH_COMPARISONS(Self) \
  template <class... T> bool operator==(const Self<T...>&, const Self<T...>&); \
  template <class... T> bool operator!=(const Self<T...>&, const Self<T...>&); \
  template <class... T> bool operator<(const Self<T...>&, const Self<T...>&); \
  template <class... T> bool operator>(const Self<T...>&, const Self<T...>&); \
  template <class... T> void swap(Self<T...>&, Self<T...>&);
