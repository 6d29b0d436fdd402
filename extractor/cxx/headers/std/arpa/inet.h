// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <netinet/in.h>
#ifdef __cplusplus
extern "C" {
#endif
in_addr_t inet_addr(const char*); char* inet_ntoa(struct in_addr); int inet_aton(const char*, struct in_addr*);
  const char* inet_ntop(int, const void*, char*, socklen_t); int inet_pton(int, const char*, void*);
#ifdef __cplusplus
}
#endif
