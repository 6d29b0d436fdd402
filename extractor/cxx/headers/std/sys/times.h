// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/c_types.h>
struct tms { clock_t tms_utime, tms_stime, tms_cutime, tms_cstime; };
#ifdef __cplusplus
extern "C"
#endif
clock_t times(struct tms*);
