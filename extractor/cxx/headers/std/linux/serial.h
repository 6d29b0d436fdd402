// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
struct serial_struct { int type; int line; int flags; int baud_base; int custom_divisor; unsigned short close_delay; };
#define ASYNC_LOW_LATENCY 0x2000
#define ASYNC_SPD_MASK 0x1030
#define ASYNC_SPD_CUST 0x0030
