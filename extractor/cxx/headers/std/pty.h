// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <termios.h>
#include <sys/ioctl.h>
#ifdef __cplusplus
extern "C" {
#endif
int openpty(int*, int*, char*, const struct termios*, const struct winsize*);
  int forkpty(int*, char*, const struct termios*, const struct winsize*);
#ifdef __cplusplus
}
#endif
