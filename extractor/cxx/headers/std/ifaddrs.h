// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sys/socket.h>
struct ifaddrs { struct ifaddrs* ifa_next; char* ifa_name; unsigned ifa_flags; struct sockaddr* ifa_addr; struct sockaddr* ifa_netmask;
  void* ifa_data; };
#ifdef __cplusplus
extern "C" {
#endif
int getifaddrs(struct ifaddrs**); void freeifaddrs(struct ifaddrs*);
#ifdef __cplusplus
}
#endif
