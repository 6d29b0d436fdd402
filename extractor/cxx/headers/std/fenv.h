// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
enum { FE_INVALID = 1, FE_DIVBYZERO = 4, FE_OVERFLOW = 8, FE_UNDERFLOW = 16, FE_ALL_EXCEPT = 61, FE_TONEAREST = 0 };
#ifdef __cplusplus
extern "C" {
#endif
int feenableexcept(int); int fedisableexcept(int); int fesetround(int); int fegetround(void); int feclearexcept(int);
#ifdef __cplusplus
}
#endif
