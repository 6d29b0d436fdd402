// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
// The tree and hash containers share one declaration each for map-like and set-like classes.
#include <bits/sequence.h>
#include <bits/function_objects.h>
#define ROSARCH_ASSOCIATIVE(Self, Key, Value, Inserted) \
  ROSARCH_CONTAINER_TYPES(Self, Value) \
  typedef Key key_type; \
  Self(); \
  Self(const Self&); \
  Self(Self&&) noexcept; \
  Self(initializer_list<Value>); \
  ROSARCH_OF_UNKNOWN(Self) \
  template <class I, class = rosarch_if_iterator<I>> Self(I, I); \
  template <class First, class... X> explicit Self(const First&, const X&...); \
  ~Self(); \
  Self& operator=(const Self&); \
  Self& operator=(Self&&) noexcept; \
  Self& operator=(initializer_list<Value>); \
  void clear() noexcept; \
  Inserted insert(const Value&); \
  Inserted insert(Value&&); \
  template <class V, class = typename enable_if<__is_constructible(Value, V)>::type> Inserted insert(V&&); \
  iterator insert(const_iterator, const Value&); \
  template <class I, class = rosarch_if_iterator<I>> void insert(I, I); \
  void insert(initializer_list<Value>); \
  template <class... X> Inserted emplace(X&&...); \
  template <class... X> iterator emplace_hint(const_iterator, X&&...); \
  iterator erase(const_iterator); \
  iterator erase(iterator); \
  iterator erase(const_iterator, const_iterator); \
  size_t erase(const Key&); \
  template <class U> rosarch_if_unknown<U, size_t> erase(const U&); \
  size_t count(const Key&) const; \
  iterator find(const Key&); \
  const_iterator find(const Key&) const; \
  bool contains(const Key&) const; \
  pair<iterator, iterator> equal_range(const Key&); \
  pair<const_iterator, const_iterator> equal_range(const Key&) const;
#define ROSARCH_ORDERED(Key, Order) \
  typedef Order key_compare; \
  Order key_comp() const; \
  iterator lower_bound(const Key&); \
  const_iterator lower_bound(const Key&) const; \
  iterator upper_bound(const Key&); \
  const_iterator upper_bound(const Key&) const;
#define ROSARCH_HASHED(Hash, Equal) \
  typedef Hash hasher; \
  typedef Equal key_equal; \
  void reserve(size_t); \
  void rehash(size_t); \
  size_t bucket_count() const noexcept; \
  float load_factor() const noexcept; \
  void max_load_factor(float);
#define ROSARCH_MAPPED(Key, T) \
  typedef T mapped_type; \
  T& operator[](const Key&); \
  T& operator[](Key&&); \
  template <class U> rosarch_if_unknown<U, T&> operator[](const U&); \
  T& at(const Key&); \
  const T& at(const Key&) const; \
  template <class... X> pair<iterator, bool> try_emplace(const Key&, X&&...); \
  template <class V> pair<iterator, bool> insert_or_assign(const Key&, V&&);
#define ROSARCH_INSERTED pair<iterator, bool>
