// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
// The result of bind: callable with anything; the type of the call is the type of what was bound, where that is known.
#include <rosarch/any.h>
namespace rosarch {
template <class F> struct bound_result { typedef any type; };
template <class R, class... P> struct bound_result<R(P...)> { typedef R type; };
template <class R, class... P> struct bound_result<R (*)(P...)> { typedef R type; };
template <class R, class C> struct bound_result<R C::*> { typedef R type; };
template <class R, class C, class... P> struct bound_result<R (C::*)(P...)> { typedef R type; };
template <class R, class C, class... P> struct bound_result<R (C::*)(P...) const> { typedef R type; };
template <class F> struct bound {
  typedef typename bound_result<F>::type result_type;
  template <class... A> result_type operator()(const A&...) const;
};
}
