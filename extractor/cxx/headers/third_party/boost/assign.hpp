// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/sequence.h>
namespace boost { namespace assign {
// Collects values of one type and becomes any container.
template <class T> class rosarch_list {
public:
  template <class... V> rosarch_list& operator()(const V&...);
  template <class C> operator C() const;
  template <class C> C convert_to_container() const;
  const T* begin() const; const T* end() const;
};
template <class T> rosarch_list<T> list_of(const T&);
template <class K, class V> rosarch_list<std::pair<K, V>> map_list_of(const K&, const V&);
template <class K, class V> rosarch_list<std::pair<K, V>> pair_list_of(const K&, const V&);
template <class C> struct rosarch_inserter { template <class... V> rosarch_inserter& operator,(const V&...);
  template <class... V> rosarch_inserter& operator()(const V&...); template <class V> rosarch_inserter& operator=(const V&); };
template <class C> rosarch_inserter<C> push_back(C&); template <class C> rosarch_inserter<C> insert(C&);
template <class T, class A, template <class, class> class C, class V> rosarch_inserter<C<T, A>> operator+=(C<T, A>&, const V&);
} }
