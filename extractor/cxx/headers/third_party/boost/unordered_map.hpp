// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <unordered_map>
#include <unordered_set>
namespace boost { using std::unordered_map; using std::unordered_multimap; using std::unordered_set; using std::hash;
  template <class T> void hash_combine(std::size_t&, const T&); }
