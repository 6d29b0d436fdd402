// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/c_types.h>
struct group { char* gr_name; gid_t gr_gid; char** gr_mem; };
#ifdef __cplusplus
extern "C" {
#endif
struct group* getgrgid(gid_t); struct group* getgrnam(const char*);
#ifdef __cplusplus
}
#endif
