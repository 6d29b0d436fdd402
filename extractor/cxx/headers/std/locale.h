// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#define LC_CTYPE 0
#define LC_NUMERIC 1
#define LC_TIME 2
#define LC_ALL 6
struct lconv { char* decimal_point; char* thousands_sep; };
#ifdef __cplusplus
extern "C" {
#endif
char* setlocale(int, const char*); struct lconv* localeconv(void);
#ifdef __cplusplus
}
#endif
