// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#define __BEGIN_DECLS extern "C" {
#define __END_DECLS }
