// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
extern "C" long syscall(long, ...);
#define SYS_gettid 186
#define __NR_gettid 186
