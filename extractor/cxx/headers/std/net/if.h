// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sys/socket.h>
#define IFNAMSIZ 16
struct ifreq { char ifr_name[IFNAMSIZ]; struct sockaddr ifr_addr; struct sockaddr ifr_hwaddr; short ifr_flags; int ifr_ifindex; int ifr_mtu;
  };
#ifdef __cplusplus
extern "C"
#endif
unsigned if_nametoindex(const char*);
enum { IFF_UP = 1, IFF_BROADCAST = 2, IFF_LOOPBACK = 8, IFF_RUNNING = 64 };
