// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
namespace boost { using std::ref; using std::cref; using std::reference_wrapper; template <class T> T& unwrap_ref(T&); }
