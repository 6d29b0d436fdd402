// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#ifdef __cplusplus
extern "C"
#endif
long syscall(long, ...);
#define SYS_gettid 186
#define __NR_gettid 186
