// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/c_types.h>
#include <sys/uio.h>
typedef unsigned short sa_family_t;
struct sockaddr { sa_family_t sa_family; char sa_data[14]; };
struct sockaddr_storage { sa_family_t ss_family; char data[126]; };
struct msghdr { void* msg_name; socklen_t msg_namelen; struct iovec* msg_iov; size_t msg_iovlen; void* msg_control; size_t msg_controllen;
  int msg_flags; };
struct linger { int l_onoff; int l_linger; };
#ifdef __cplusplus
extern "C" {
#endif
int socket(int, int, int); int socketpair(int, int, int, int*); int bind(int, const struct sockaddr*, socklen_t);
  int connect(int, const struct sockaddr*, socklen_t);
int listen(int, int); int accept(int, struct sockaddr*, socklen_t*); int shutdown(int, int);
ssize_t send(int, const void*, size_t, int); ssize_t recv(int, void*, size_t, int);
ssize_t sendto(int, const void*, size_t, int, const struct sockaddr*, socklen_t);
  ssize_t recvfrom(int, void*, size_t, int, struct sockaddr*, socklen_t*);
ssize_t sendmsg(int, const struct msghdr*, int); ssize_t recvmsg(int, struct msghdr*, int);
int setsockopt(int, int, int, const void*, socklen_t); int getsockopt(int, int, int, void*, socklen_t*);
  int getsockname(int, struct sockaddr*, socklen_t*); int getpeername(int, struct sockaddr*, socklen_t*);
#ifdef __cplusplus
}
#endif
enum { SOCK_STREAM = 1, SOCK_DGRAM = 2, SOCK_RAW = 3, SOCK_NONBLOCK = 2048, SOCK_CLOEXEC = 524288, PF_UNSPEC = 0, PF_UNIX = 1, PF_INET = 2,
  PF_INET6 = 10, PF_PACKET = 17, PF_CAN = 29,
  AF_UNSPEC = 0, AF_UNIX = 1, AF_LOCAL = 1, AF_INET = 2, AF_INET6 = 10, AF_PACKET = 17, AF_CAN = 29, SOL_SOCKET = 1, SO_DEBUG = 1,
    SO_REUSEADDR = 2, SO_ERROR = 4, SO_BROADCAST = 6,
  SO_SNDBUF = 7, SO_RCVBUF = 8, SO_KEEPALIVE = 9, SO_LINGER = 13, SO_REUSEPORT = 15, SO_RCVTIMEO = 20, SO_SNDTIMEO = 21, SO_TIMESTAMP = 29,
    SO_BINDTODEVICE = 25, SOMAXCONN = 4096,
  MSG_OOB = 1, MSG_PEEK = 2, MSG_DONTWAIT = 64, MSG_WAITALL = 256, MSG_NOSIGNAL = 16384, SHUT_RD = 0, SHUT_WR = 1, SHUT_RDWR = 2 };
