// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
namespace boost {
template <class Signature> class function;
template <class R, class... P> class function<R(P...)> {
public:
  typedef R result_type;
  function();
  function(std::nullptr_t);
  function(const function&);
  template <class F, class = typename std::enable_if<!std::is_same<typename std::decay<F>::type, function>::value>::type> function(F&&);
  function& operator=(const function&);
  template <class F> function& operator=(F&&);
  R operator()(P...) const;
  explicit operator bool() const;
  bool operator!() const;
  bool empty() const;
  void clear();
  void swap(function&);
};
template <class S> bool operator==(const function<S>&, std::nullptr_t);
template <class S> bool operator!=(const function<S>&, std::nullptr_t);
template <class R> using function0 = function<R()>;
template <class R, class A> using function1 = function<R(A)>;
template <class R, class A, class B> using function2 = function<R(A, B)>;
template <class R, class A, class B, class C> using function3 = function<R(A, B, C)>;
}
