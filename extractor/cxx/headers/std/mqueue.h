// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/c_types.h>
#include <fcntl.h>
typedef int mqd_t;
struct mq_attr { long mq_flags; long mq_maxmsg; long mq_msgsize; long mq_curmsgs; };
#ifdef __cplusplus
extern "C" {
#endif
mqd_t mq_open(const char*, int, ...); int mq_close(mqd_t); int mq_unlink(const char*);
  int mq_send(mqd_t, const char*, size_t, unsigned); ssize_t mq_receive(mqd_t, char*, size_t, unsigned*);
int mq_getattr(mqd_t, struct mq_attr*); int mq_setattr(mqd_t, const struct mq_attr*, struct mq_attr*);
  ssize_t mq_timedreceive(mqd_t, char*, size_t, unsigned*, const struct timespec*);
#ifdef __cplusplus
}
#endif
