// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <functional>
namespace boost { template <class R, class C> rosarch::bound<R C::*> mem_fn(R C::*); }
