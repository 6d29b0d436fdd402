// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#ifdef __cplusplus
extern "C" {
#endif
unsigned long crc32(unsigned long, const unsigned char*, unsigned); unsigned long compressBound(unsigned long);
  int uncompress(unsigned char*, unsigned long*, const unsigned char*, unsigned long);
#ifdef __cplusplus
}
#endif
