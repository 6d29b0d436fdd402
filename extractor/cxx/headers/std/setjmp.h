// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
typedef long jmp_buf[32];
#ifdef __cplusplus
extern "C" {
#endif
int setjmp(jmp_buf); void longjmp(jmp_buf, int);
#ifdef __cplusplus
}
#endif
