// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <netinet/in.h>
struct hostent { char* h_name; char** h_aliases; int h_addrtype; int h_length; char** h_addr_list; };
#define h_addr h_addr_list[0]
struct addrinfo { int ai_flags; int ai_family; int ai_socktype; int ai_protocol; socklen_t ai_addrlen; struct sockaddr* ai_addr;
  char* ai_canonname; struct addrinfo* ai_next; };
#ifdef __cplusplus
extern "C" {
#endif
struct hostent* gethostbyname(const char*);
  int getaddrinfo(const char*, const char*, const struct addrinfo*, struct addrinfo**); void freeaddrinfo(struct addrinfo*);
const char* gai_strerror(int); int getnameinfo(const struct sockaddr*, socklen_t, char*, socklen_t, char*, socklen_t, int);
  void herror(const char*);
#ifdef __cplusplus
}
#endif
enum { AI_PASSIVE = 1, AI_CANONNAME = 2, AI_NUMERICHOST = 4, NI_NUMERICHOST = 1, NI_NUMERICSERV = 2 };
#ifdef __cplusplus
extern "C"
#endif
int h_errno;
