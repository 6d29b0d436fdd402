// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sys/ipc.h>
#ifdef __cplusplus
extern "C" {
#endif
int msgget(key_t, int); int msgsnd(int, const void*, size_t, int); ssize_t msgrcv(int, void*, size_t, long, int);
  int msgctl(int, int, void*);
#ifdef __cplusplus
}
#endif
