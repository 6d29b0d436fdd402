// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#define RCUTILS_EXPORT
#define RCUTILS_IMPORT
#define RCUTILS_LOCAL
