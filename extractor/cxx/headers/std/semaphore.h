// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/c_types.h>
typedef union { char size[32]; long align; } sem_t;
#define SEM_FAILED ((sem_t*)0)
#ifdef __cplusplus
extern "C" {
#endif
int sem_init(sem_t*, int, unsigned); int sem_destroy(sem_t*); sem_t* sem_open(const char*, int, ...); int sem_close(sem_t*);
  int sem_unlink(const char*);
int sem_wait(sem_t*); int sem_trywait(sem_t*); int sem_timedwait(sem_t*, const struct timespec*); int sem_post(sem_t*);
  int sem_getvalue(sem_t*, int*);
#ifdef __cplusplus
}
#endif
