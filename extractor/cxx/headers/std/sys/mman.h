// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/c_types.h>
#ifdef __cplusplus
extern "C" {
#endif
void* mmap(void*, size_t, int, int, int, off_t); int munmap(void*, size_t); int msync(void*, size_t, int); int mlockall(int);
  int munlockall(void); int mlock(const void*, size_t); int shm_open(const char*, int, mode_t); int shm_unlink(const char*);
  int mprotect(void*, size_t, int);
#ifdef __cplusplus
}
#endif
#define PROT_READ 1
#define PROT_WRITE 2
#define PROT_EXEC 4
#define MAP_SHARED 1
#define MAP_PRIVATE 2
#define MAP_ANONYMOUS 32
#define MAP_FAILED ((void*)-1)
#define MCL_CURRENT 1
#define MCL_FUTURE 2
#define MS_SYNC 4
