// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
#include <boost/ref.hpp>
#include <boost/mem_fn.hpp>
namespace boost {
// What is bound is not checked; arguments stay free of conversions.
template <class F, class... A> rosarch::bound<F> bind(const F&, const A&...);
template <class R, class F, class... A> rosarch::bound<R()> bind(const F&, const A&...);
template <class T> T& protect(T&);
// The same entities as std::placeholders, so that `using namespace std::placeholders` is never ambiguous.
namespace placeholders {
using std::placeholders::_1; using std::placeholders::_2; using std::placeholders::_3; using std::placeholders::_4;
  using std::placeholders::_5;
using std::placeholders::_6; using std::placeholders::_7; using std::placeholders::_8; using std::placeholders::_9;
}
template <int n> using arg = std::rosarch_placeholder<n>;
}
using namespace boost::placeholders;
