// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/c_types.h>
#ifdef __cplusplus
extern "C" {
#endif
pid_t wait(int*); pid_t waitpid(pid_t, int*, int); int WIFEXITED(int); int WEXITSTATUS(int); int WIFSIGNALED(int);
  int WTERMSIG(int); int WIFSTOPPED(int); int WSTOPSIG(int);
#ifdef __cplusplus
}
#endif
#define WNOHANG 1
#define WUNTRACED 2
