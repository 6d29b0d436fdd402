// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <tuple>
namespace boost {
template <class... T> class tuple : public std::tuple<T...> { public: using std::tuple<T...>::tuple;
  template <int i> typename std::tuple_element<i, std::tuple<T...>>::type& get() const; };
template <int i, class... T> typename std::tuple_element<i, std::tuple<T...>>::type& get(const tuple<T...>&);
template <class... T> tuple<T...> make_tuple(const T&...); template <class... T> tuple<T&...> tie(T&...);
namespace tuples { using boost::get; using boost::make_tuple; using boost::tie; using boost::tuple; }
}
