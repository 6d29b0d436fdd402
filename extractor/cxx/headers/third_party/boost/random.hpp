// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <random>
namespace boost {
namespace random { using std::mt19937; using std::uniform_int_distribution; using std::uniform_real_distribution;
  using std::normal_distribution; using std::random_device; }
using std::mt19937; typedef std::mt19937 minstd_rand; using std::normal_distribution;
template <class T = int> using uniform_int = std::uniform_int_distribution<T>;
  template <class T = double> using uniform_real = std::uniform_real_distribution<T>;
  typedef std::uniform_real_distribution<double> uniform_01;
template <class E, class D> class variate_generator { public: variate_generator(E, D); typename D::result_type operator()(); };
}
