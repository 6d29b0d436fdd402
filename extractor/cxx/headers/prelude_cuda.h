// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
// What a CUDA source sees first: the compiler's own declarations, and those of the common prelude, which is precompiled for C++ alone.
#include <cuda_runtime.h>
#include "prelude.h"
