// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/c_types.h>
struct passwd { char* pw_name; char* pw_passwd; uid_t pw_uid; gid_t pw_gid; char* pw_gecos; char* pw_dir; char* pw_shell; };
#ifdef __cplusplus
extern "C" {
#endif
struct passwd* getpwuid(uid_t); struct passwd* getpwnam(const char*);
#ifdef __cplusplus
}
#endif
