// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/c_types.h>
struct iovec { void* iov_base; size_t iov_len; };
#ifdef __cplusplus
extern "C" {
#endif
ssize_t readv(int, const struct iovec*, int); ssize_t writev(int, const struct iovec*, int);
#ifdef __cplusplus
}
#endif
