// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stddef.h>
typedef struct { size_t we_wordc; char** we_wordv; size_t we_offs; } wordexp_t;
#ifdef __cplusplus
extern "C" {
#endif
int wordexp(const char*, wordexp_t*, int); void wordfree(wordexp_t*);
#ifdef __cplusplus
}
#endif
