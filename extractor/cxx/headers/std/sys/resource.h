// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/c_types.h>
struct rusage { struct timeval ru_utime; struct timeval ru_stime; long ru_maxrss; };
typedef unsigned long rlim_t;
struct rlimit { rlim_t rlim_cur; rlim_t rlim_max; };
#ifdef __cplusplus
extern "C" {
#endif
int getrusage(int, struct rusage*); int getrlimit(int, struct rlimit*); int setrlimit(int, const struct rlimit*);
  int setpriority(int, id_t, int); int getpriority(int, id_t);
#ifdef __cplusplus
}
#endif
enum { RUSAGE_SELF = 0, RLIMIT_STACK = 3, RLIMIT_CORE = 4, RLIMIT_NOFILE = 7, RLIMIT_MEMLOCK = 8, RLIMIT_RTPRIO = 14, PRIO_PROCESS = 0 };
