// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
namespace boost {
template <class C> auto begin(C& c) -> decltype(c.begin()); template <class C> auto end(C& c) -> decltype(c.end());
  template <class C> std::size_t size(const C&); template <class C> bool empty(const C&);
template <class I> class iterator_range { public: iterator_range(); iterator_range(I, I); I begin() const; I end() const;
  bool empty() const; std::size_t size() const; }; template <class I> iterator_range<I> make_iterator_range(I, I);
namespace adaptors { struct rosarch_adaptor {}; extern rosarch_adaptor map_values, map_keys, reversed;
  template <class C> C& operator|(C& c, rosarch_adaptor); template <class F> rosarch_adaptor transformed(const F&);
  template <class F> rosarch_adaptor filtered(const F&); }
namespace algorithm { } 
template <class C, class... X> void sort(C&, const X&...); template <class C, class F> F for_each(C&&, F);
  template <class C, class T> auto find(C& c, const T&) -> decltype(c.begin()); template <class C> void reverse(C&);
}
