// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <time.h>
#ifdef __cplusplus
extern "C" {
#endif
int timerfd_create(int, int); int timerfd_settime(int, int, const struct itimerspec*, struct itimerspec*);
#ifdef __cplusplus
}
#endif
