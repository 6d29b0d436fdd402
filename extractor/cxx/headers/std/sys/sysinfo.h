// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
struct sysinfo { long uptime; unsigned long loads[3]; unsigned long totalram; unsigned long freeram; unsigned short procs;
  unsigned mem_unit; };
#ifdef __cplusplus
extern "C" {
#endif
int sysinfo(struct sysinfo*); int get_nprocs(void);
#ifdef __cplusplus
}
#endif
