// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/c_types.h>
struct timeb { time_t time; unsigned short millitm; short timezone; short dstflag; };
#ifdef __cplusplus
extern "C"
#endif
int ftime(struct timeb*);
