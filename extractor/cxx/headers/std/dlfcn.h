// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#ifdef __cplusplus
extern "C" {
#endif
void* dlopen(const char*, int); void* dlsym(void*, const char*); int dlclose(void*); char* dlerror(void);
#ifdef __cplusplus
}
#endif
#define RTLD_LAZY 1
#define RTLD_NOW 2
#define RTLD_GLOBAL 256
#define RTLD_LOCAL 0
