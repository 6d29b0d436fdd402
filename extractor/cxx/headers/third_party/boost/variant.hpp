// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <variant>
namespace boost {
template <class... T> class variant : public std::variant<T...> { public: using std::variant<T...>::variant; int which() const;
  bool empty() const; template <class U> variant& operator=(const U&); };
template <class R = void> struct static_visitor { typedef R result_type; };
template <class X, class... T> X& get(const variant<T...>&); template <class X, class... T> X* get(variant<T...>*);
  template <class V, class... X> typename V::result_type apply_visitor(const V&, X&&...);
}
