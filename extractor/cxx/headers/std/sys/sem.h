// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sys/ipc.h>
struct sembuf { unsigned short sem_num; short sem_op; short sem_flg; };
#ifdef __cplusplus
extern "C" {
#endif
int semget(key_t, int, int); int semop(int, struct sembuf*, size_t); int semctl(int, int, int, ...);
#ifdef __cplusplus
}
#endif
#define SETVAL 16
#define GETVAL 12
#define SEM_UNDO 0x1000
