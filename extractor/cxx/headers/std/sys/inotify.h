// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stdint.h>
struct inotify_event { int wd; uint32_t mask; uint32_t cookie; uint32_t len; char name[1]; };
#ifdef __cplusplus
extern "C" {
#endif
int inotify_init(void); int inotify_add_watch(int, const char*, uint32_t); int inotify_rm_watch(int, int);
#ifdef __cplusplus
}
#endif
