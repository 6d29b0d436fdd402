// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stdint.h>
typedef union epoll_data { void* ptr; int fd; uint32_t u32; uint64_t u64; } epoll_data_t;
struct epoll_event { uint32_t events; epoll_data_t data; };
#ifdef __cplusplus
extern "C" {
#endif
int epoll_create(int); int epoll_create1(int); int epoll_ctl(int, int, int, struct epoll_event*);
  int epoll_wait(int, struct epoll_event*, int, int);
#ifdef __cplusplus
}
#endif
enum { EPOLLIN = 1, EPOLLPRI = 2, EPOLLOUT = 4, EPOLLERR = 8, EPOLLHUP = 16, EPOLL_CTL_ADD = 1, EPOLL_CTL_DEL = 2, EPOLL_CTL_MOD = 3 };
