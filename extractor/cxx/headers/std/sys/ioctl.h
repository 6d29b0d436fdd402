// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#ifdef __cplusplus
extern "C"
#endif
int ioctl(int, unsigned long, ...);
struct winsize { unsigned short ws_row, ws_col, ws_xpixel, ws_ypixel; };
#define TIOCGWINSZ 0x5413
#define FIONREAD 0x541B
#define FIONBIO 0x5421
#define TIOCMGET 0x5415
#define TIOCMBIS 0x5416
#define TIOCMBIC 0x5417
#define TIOCMSET 0x5418
#define TIOCEXCL 0x540C
#define TIOCNXCL 0x540D
#define TIOCM_DTR 0x002
#define TIOCM_RTS 0x004
#define TIOCM_CTS 0x020
#define TIOCM_DSR 0x100
#define TIOCM_CD 0x040
#define TIOCM_RI 0x080
#define TIOCGSERIAL 0x541E
#define TIOCSSERIAL 0x541F
#define TIOCINQ FIONREAD
