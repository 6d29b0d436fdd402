// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/c_types.h>
struct sched_param { int sched_priority; };
typedef struct { unsigned long bits[16]; } cpu_set_t;
enum { SCHED_OTHER, SCHED_FIFO, SCHED_RR, SCHED_BATCH };
#ifdef __cplusplus
extern "C" {
#endif
int sched_yield(void); int sched_setscheduler(pid_t, int, const struct sched_param*); int sched_get_priority_max(int);
  int sched_get_priority_min(int);
int sched_setparam(pid_t, const struct sched_param*); int sched_setaffinity(pid_t, size_t, const cpu_set_t*); int sched_getcpu(void);
  void CPU_ZERO(cpu_set_t*); void CPU_SET(int, cpu_set_t*);
#ifdef __cplusplus
}
#endif
