// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
namespace boost { namespace math {
template <class T> bool isnan(T); template <class T> bool isinf(T); template <class T> bool isfinite(T); template <class T> int sign(T);
  template <class T> T round(T); template <class T> int iround(T);
namespace constants { template <class T> constexpr T pi() { return T(); } template <class T> constexpr T two_pi() { return T(); }
  template <class T> constexpr T half_pi() { return T(); } }
template <class T = double> class normal_distribution { public: explicit normal_distribution(T = 0, T = 1); T mean() const;
  T standard_deviation() const; }; typedef normal_distribution<double> normal;
template <class D, class T> double pdf(const D&, T); template <class D, class T> double cdf(const D&, T);
  template <class D, class T> double quantile(const D&, T);
template <class T = double> using chi_squared_distribution = normal_distribution<T>; typedef normal_distribution<double> chi_squared;
} }
