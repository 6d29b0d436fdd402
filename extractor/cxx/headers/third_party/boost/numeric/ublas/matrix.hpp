// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
namespace boost { namespace numeric {
namespace ublas { template <class T> class matrix { public: matrix(std::size_t = 0, std::size_t = 0);
  T& operator()(std::size_t, std::size_t); const T& operator()(std::size_t, std::size_t) const; std::size_t size1() const;
  std::size_t size2() const; }; template <class T> class vector { public: vector(std::size_t = 0); T& operator()(std::size_t);
  T& operator[](std::size_t); std::size_t size() const; }; }
template <class T, class S> T converter(const S&); } 
template <class T, class S> T numeric_cast(const S&); template <class T, class S> T implicit_cast(const S&);
  template <class T, class S> T polymorphic_downcast(S*); namespace numeric { using boost::numeric_cast; class bad_numeric_cast {}; } }
