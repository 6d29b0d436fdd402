// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
// A value of which nothing is known. It converts to an lvalue of any type, and to nothing else: one conversion, so that
// it is never ambiguous. Everything can be asked of it but named members.
namespace rosarch {
struct any {
  any();
  any(const any&);
  template <class A, class... B> any(const A&, const B&...);
  template <class T> operator T&() const;
  template <class T> any& operator=(const T&);
  template <class... A> any operator()(const A&...) const;
  template <class I> any& operator[](const I&) const;
  any* operator->() const;
  any& operator*() const;
  any& operator++();
  any& operator++(int);
  template <class T> any& operator+=(const T&);
  template <class T> any& operator-=(const T&);
  template <class T> any& operator<<(const T&);
};
}
