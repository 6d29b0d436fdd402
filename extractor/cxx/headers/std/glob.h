// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stddef.h>
typedef struct { size_t gl_pathc; char** gl_pathv; size_t gl_offs; } glob_t;
#ifdef __cplusplus
extern "C" {
#endif
int glob(const char*, int, int (*)(const char*, int), glob_t*); void globfree(glob_t*);
#ifdef __cplusplus
}
#endif
#define GLOB_TILDE 4096
