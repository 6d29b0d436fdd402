// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
extern "C" { void* dlopen(const char*, int); void* dlsym(void*, const char*); int dlclose(void*); char* dlerror(void); }
#define RTLD_LAZY 1
#define RTLD_NOW 2
#define RTLD_GLOBAL 256
#define RTLD_LOCAL 0
