// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
typedef unsigned long nfds_t;
struct pollfd { int fd; short events; short revents; };
#ifdef __cplusplus
extern "C"
#endif
int poll(struct pollfd*, nfds_t, int);
#define POLLIN 1
#define POLLPRI 2
#define POLLOUT 4
#define POLLERR 8
#define POLLHUP 16
#define POLLNVAL 32
