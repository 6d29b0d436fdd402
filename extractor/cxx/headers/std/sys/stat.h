// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/c_types.h>
struct stat {
  dev_t st_dev; ino_t st_ino; nlink_t st_nlink; mode_t st_mode; uid_t st_uid; gid_t st_gid; dev_t st_rdev; off_t st_size;
    blksize_t st_blksize;
  blkcnt_t st_blocks; time_t st_atime; time_t st_mtime; time_t st_ctime; struct timespec st_atim; struct timespec st_mtim;
    struct timespec st_ctim;
};
#ifdef __cplusplus
extern "C" {
#endif
int stat(const char*, struct stat*); int fstat(int, struct stat*); int lstat(const char*, struct stat*); int mkdir(const char*, mode_t);
int mkfifo(const char*, mode_t); int chmod(const char*, mode_t); int fchmod(int, mode_t); mode_t umask(mode_t);
int S_ISDIR(mode_t); int S_ISREG(mode_t); int S_ISLNK(mode_t); int S_ISCHR(mode_t); int S_ISFIFO(mode_t); int S_ISSOCK(mode_t);
  int S_ISBLK(mode_t);
#ifdef __cplusplus
}
#endif
#define S_IFMT 0170000
#define S_IFDIR 0040000
#define S_IFREG 0100000
#define S_IRWXU 0700
#define S_IRUSR 0400
#define S_IWUSR 0200
#define S_IXUSR 0100
#define S_IRWXG 0070
#define S_IRGRP 0040
#define S_IWGRP 0020
#define S_IXGRP 0010
#define S_IRWXO 0007
#define S_IROTH 0004
#define S_IWOTH 0002
#define S_IXOTH 0001
#define ACCESSPERMS 0777
