// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <time.h>
#ifdef __cplusplus
extern "C" {
#endif
int gettimeofday(struct timeval*, void*);
int settimeofday(const struct timeval*, const struct timezone*);
int setitimer(int, const struct itimerval*, struct itimerval*);
int getitimer(int, struct itimerval*);
int utimes(const char*, const struct timeval*);
#ifdef __cplusplus
}
#endif
#define ITIMER_REAL 0
#define ITIMER_VIRTUAL 1
#define ITIMER_PROF 2
#define timeradd(a, b, result) ((void)(a), (void)(b), (void)(result))
#define timersub(a, b, result) ((void)(a), (void)(b), (void)(result))
#define timerclear(tvp) ((tvp)->tv_sec = (tvp)->tv_usec = 0)
