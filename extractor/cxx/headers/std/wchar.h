// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stddef.h>
#include <stdio.h>
typedef unsigned int wint_t;
typedef struct { int state; } mbstate_t;
#ifdef __cplusplus
extern "C" {
#endif
size_t wcslen(const wchar_t*);
wchar_t* wcscpy(wchar_t*, const wchar_t*);
int wcscmp(const wchar_t*, const wchar_t*);
int wprintf(const wchar_t*, ...);
int swprintf(wchar_t*, size_t, const wchar_t*, ...);
#ifdef __cplusplus
}
#endif
#define WEOF (0xffffffffu)
