// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sys/ipc.h>
struct shmid_ds { size_t shm_segsz; int shm_nattch; };
#ifdef __cplusplus
extern "C" {
#endif
int shmget(key_t, size_t, int); void* shmat(int, const void*, int); int shmdt(const void*);
  int shmctl(int, int, struct shmid_ds*);
#ifdef __cplusplus
}
#endif
