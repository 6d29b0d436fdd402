// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cmath>
#define ROSARCH_NAMESPACE tf
#include <rosarch/linear_math.inc>
#define TFSIMD_PI 3.1415926535897932384626433832795029
#define TFSIMD_HALF_PI (TFSIMD_PI / 2)
#define TFSIMD_2_PI (TFSIMD_PI * 2)
#define TFSIMD_EPSILON 2.2204460492503131e-16
#define TFSIMD_INFINITY 1.7976931348623157e+308
#define TFSIMD_RADS_PER_DEG (TFSIMD_PI / 180)
