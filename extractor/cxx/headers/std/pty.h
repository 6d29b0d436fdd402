// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <termios.h>
#include <sys/ioctl.h>
extern "C" { int openpty(int*, int*, char*, const struct termios*, const struct winsize*);
  int forkpty(int*, char*, const struct termios*, const struct winsize*); }
