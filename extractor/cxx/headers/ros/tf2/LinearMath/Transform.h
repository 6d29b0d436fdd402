// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#define ROSARCH_NAMESPACE tf2
#include <rosarch/linear_math.inc>
#define TF2SIMD_PI 3.1415926535897932384626433832795029
#define TF2SIMD_HALF_PI (TF2SIMD_PI / 2)
#define TF2SIMD_EPSILON 2.2204460492503131e-16
#define TF2_SIMD_PI 3.1415926535897932384626433832795029
