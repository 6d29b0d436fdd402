// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/c_types.h>
#ifdef __cplusplus
extern "C" {
#endif
unsigned sleep(unsigned); int usleep(useconds_t); unsigned alarm(unsigned); int pause(void);
ssize_t read(int, void*, size_t); ssize_t write(int, const void*, size_t); ssize_t pread(int, void*, size_t, off_t);
  ssize_t pwrite(int, const void*, size_t, off_t);
int close(int); off_t lseek(int, off_t, int); int ftruncate(int, off_t); int truncate(const char*, off_t); int fsync(int);
int pipe(int*); int dup(int); int dup2(int, int); int isatty(int); char* ttyname(int);
int access(const char*, int); int unlink(const char*); int rmdir(const char*); int chdir(const char*); char* getcwd(char*, size_t);
  int chown(const char*, uid_t, gid_t);
int link(const char*, const char*); int symlink(const char*, const char*); ssize_t readlink(const char*, char*, size_t);
pid_t fork(void); pid_t vfork(void); pid_t getpid(void); pid_t getppid(void); pid_t setsid(void); int setpgid(pid_t, pid_t);
  pid_t getpgrp(void); pid_t tcgetpgrp(int);
uid_t getuid(void); uid_t geteuid(void); gid_t getgid(void); gid_t getegid(void); int setuid(uid_t); int setgid(gid_t);
int execl(const char*, const char*, ...); int execlp(const char*, const char*, ...); int execv(const char*, char* const*);
  int execvp(const char*, char* const*); int execve(const char*, char* const*, char* const*);
void _exit(int) __attribute__((noreturn)); long sysconf(int); int gethostname(char*, size_t); int getpagesize(void); int nice(int);
  char* getlogin(void);
int getopt(int, char* const*, const char*); long syscall(long, ...); int daemon(int, int);
extern char* optarg; extern int optind; extern int opterr; extern int optopt; extern char** environ;
#ifdef __cplusplus
}
#endif
#define STDIN_FILENO 0
#define STDOUT_FILENO 1
#define STDERR_FILENO 2
#define F_OK 0
#define X_OK 1
#define W_OK 2
#define R_OK 4
#define _SC_PAGESIZE 30
#define _SC_NPROCESSORS_ONLN 84
#define _SC_CLK_TCK 2
