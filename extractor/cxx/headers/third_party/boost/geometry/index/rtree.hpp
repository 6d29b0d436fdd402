// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <iterator>
#include <memory>
namespace boost { namespace geometry { namespace index {
template <std::size_t max, std::size_t min = 1> struct linear {};
template <std::size_t max, std::size_t min = 1> struct quadratic {};
template <std::size_t max, std::size_t min = 1, std::size_t reinserted = 1, std::size_t tolerance = 32> struct rstar {};
struct dynamic_linear { explicit dynamic_linear(std::size_t, std::size_t = 0); };
struct dynamic_quadratic { explicit dynamic_quadratic(std::size_t, std::size_t = 0); };
struct dynamic_rstar { explicit dynamic_rstar(std::size_t, std::size_t = 0, std::size_t = 0, std::size_t = 0); };
template <class V> struct indexable {};
template <class V> struct equal_to {};

struct rosarch_predicate {};
template <class G> rosarch_predicate nearest(const G&, std::size_t);
template <class G> rosarch_predicate intersects(const G&); template <class G> rosarch_predicate within(const G&);
template <class G> rosarch_predicate covered_by(const G&); template <class G> rosarch_predicate contains(const G&);
template <class G> rosarch_predicate covers(const G&); template <class G> rosarch_predicate disjoint(const G&);
template <class G> rosarch_predicate overlaps(const G&); template <class F> rosarch_predicate satisfies(F);
rosarch_predicate operator&&(const rosarch_predicate&, const rosarch_predicate&); rosarch_predicate operator!(const rosarch_predicate&);

template <class V, class P, class I = indexable<V>, class E = equal_to<V>, class A = std::allocator<V>> class rtree {
public:
  typedef V value_type; typedef P parameters_type; typedef I indexable_getter; typedef E value_equal; typedef A allocator_type;
  typedef std::size_t size_type; typedef std::rosarch_iterator<const V, rtree> const_iterator; typedef const_iterator const_query_iterator;
  struct bounds_type { template <class T> operator T() const; };
  rtree(); explicit rtree(const P&, const I& = I(), const E& = E()); template <class R> explicit rtree(const R&, const P& = P());
  template <class It> rtree(It, It, const P& = P(), const I& = I(), const E& = E());
  void insert(const V&); template <class R> void insert(const R&); template <class It> void insert(It, It);
  size_type remove(const V&); template <class R> size_type remove(const R&); template <class It> size_type remove(It, It);
  template <class O> size_type query(const rosarch_predicate&, O) const;
  const_query_iterator qbegin(const rosarch_predicate&) const; const_query_iterator qend() const;
  const_iterator begin() const; const_iterator end() const; size_type size() const; bool empty() const; void clear();
  bounds_type bounds() const; template <class G> size_type count(const G&) const; void swap(rtree&);
};
}}}
