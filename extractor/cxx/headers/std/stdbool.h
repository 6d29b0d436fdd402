// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <iso646.h>
#ifndef __cplusplus
#define bool _Bool
#define true 1
#define false 0
#endif
