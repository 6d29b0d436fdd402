// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#ifdef __cplusplus
extern "C" {
#endif
void openlog(const char*, int, int); void syslog(int, const char*, ...); void closelog(void);
#ifdef __cplusplus
}
#endif
enum { LOG_EMERG, LOG_ALERT, LOG_CRIT, LOG_ERR, LOG_WARNING, LOG_NOTICE, LOG_INFO, LOG_DEBUG, LOG_PID = 1, LOG_CONS = 2, LOG_USER = 8,
  LOG_DAEMON = 24 };
