// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#ifdef __cplusplus
extern "C"
#endif
int prctl(int, ...);
#define PR_SET_NAME 15
#define PR_SET_PDEATHSIG 1
