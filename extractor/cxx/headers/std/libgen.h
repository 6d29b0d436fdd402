// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#ifdef __cplusplus
extern "C" {
#endif
char* dirname(char*); char* basename(char*);
#ifdef __cplusplus
}
#endif
