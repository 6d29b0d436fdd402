// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stddef.h>
#ifdef __cplusplus
extern "C" {
#endif
void* memcpy(void*, const void*, size_t);
void* memmove(void*, const void*, size_t);
void* memset(void*, int, size_t);
int memcmp(const void*, const void*, size_t);
char* strcpy(char*, const char*);
char* strncpy(char*, const char*, size_t);
char* strcat(char*, const char*);
char* strncat(char*, const char*, size_t);
int strcmp(const char*, const char*);
int strncmp(const char*, const char*, size_t);
int strcoll(const char*, const char*);
int strcasecmp(const char*, const char*);
int strncasecmp(const char*, const char*, size_t);
size_t strlen(const char*);
size_t strnlen(const char*, size_t);
size_t strspn(const char*, const char*);
size_t strcspn(const char*, const char*);
char* strtok(char*, const char*);
char* strtok_r(char*, const char*, char**);
char* strsep(char**, const char*);
char* strdup(const char*);
char* strndup(const char*, size_t);
char* strerror(int);
char* strerror_r(int, char*, size_t);
char* strsignal(int);
char* index(const char*, int);
char* rindex(const char*, int);
void bzero(void*, size_t);
void bcopy(const void*, void*, size_t);
#ifdef __cplusplus
}
#endif
// Two overloads each, as in C++ libraries: const in, const out.
#ifdef __cplusplus
extern "C++" {
const void* memchr(const void*, int, size_t);
void* memchr(void*, int, size_t);
const char* strchr(const char*, int);
char* strchr(char*, int);
const char* strrchr(const char*, int);
char* strrchr(char*, int);
const char* strstr(const char*, const char*);
char* strstr(char*, const char*);
const char* strpbrk(const char*, const char*);
char* strpbrk(char*, const char*);
}
#else
void* memchr(const void*, int, size_t);
char* strchr(const char*, int);
char* strrchr(const char*, int);
char* strstr(const char*, const char*);
char* strpbrk(const char*, const char*);
#endif
