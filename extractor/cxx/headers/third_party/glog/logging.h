// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <gflags/gflags.h>
#include <ostream>
#include <string>
#include <vector>
namespace google {
typedef int LogSeverity;
const int GLOG_INFO = 0, GLOG_WARNING = 1, GLOG_ERROR = 2, GLOG_FATAL = 3, NUM_SEVERITIES = 4;
const int INFO = GLOG_INFO, WARNING = GLOG_WARNING, ERROR = GLOG_ERROR, FATAL = GLOG_FATAL;
void InitGoogleLogging(const char* argv0);
void ShutdownGoogleLogging();
void InstallFailureSignalHandler();
void SetLogDestination(LogSeverity severity, const char* base_filename);
void SetStderrLogging(LogSeverity severity);
void LogToStderr();
void FlushLogFiles(LogSeverity severity);
class LogSink {
public:
  virtual ~LogSink();
  virtual void send(LogSeverity severity, const char* full_filename, const char* base_filename, int line, const struct ::tm* time, const char* message, unsigned long length);
  virtual void WaitTillSent();
  static std::string ToString(LogSeverity severity, const char* file, int line, const struct ::tm* time, const char* message, unsigned long length);
};
void AddLogSink(LogSink* sink);
void RemoveLogSink(LogSink* sink);
std::ostream& rosarch_log(int severity);
template <typename... A> std::ostream& rosarch_check(const A&... condition);
template <typename T> T&& rosarch_not_null(T&& pointer);
}  // namespace google
#define LOG(severity) ::google::rosarch_log(::google::severity)
#define LOG_IF(severity, condition) ::google::rosarch_check(condition)
#define LOG_EVERY_N(severity, n) ::google::rosarch_check(n)
#define LOG_FIRST_N(severity, n) ::google::rosarch_check(n)
#define LOG_IF_EVERY_N(severity, condition, n) ::google::rosarch_check(condition, n)
#define PLOG(severity) LOG(severity)
#define VLOG(level) ::google::rosarch_log(level)
#define VLOG_IF(level, condition) ::google::rosarch_check(condition)
#define VLOG_IS_ON(level) (level > 0)
#define DLOG(severity) LOG(severity)
#define DLOG_IF(severity, condition) LOG_IF(severity, condition)
#define CHECK(condition) ::google::rosarch_check(condition)
#define PCHECK(condition) ::google::rosarch_check(condition)
#define CHECK_EQ(a, b) ::google::rosarch_check((a) == (b))
#define CHECK_NE(a, b) ::google::rosarch_check((a) != (b))
#define CHECK_LT(a, b) ::google::rosarch_check((a) < (b))
#define CHECK_LE(a, b) ::google::rosarch_check((a) <= (b))
#define CHECK_GT(a, b) ::google::rosarch_check((a) > (b))
#define CHECK_GE(a, b) ::google::rosarch_check((a) >= (b))
#define CHECK_NEAR(a, b, margin) ::google::rosarch_check(a, b, margin)
#define CHECK_DOUBLE_EQ(a, b) ::google::rosarch_check(a, b)
#define CHECK_STREQ(a, b) ::google::rosarch_check(a, b)
#define CHECK_STRNE(a, b) ::google::rosarch_check(a, b)
#define CHECK_NOTNULL(pointer) ::google::rosarch_not_null(pointer)
#define DCHECK(condition) CHECK(condition)
#define DCHECK_EQ(a, b) CHECK_EQ(a, b)
#define DCHECK_NE(a, b) CHECK_NE(a, b)
#define DCHECK_LT(a, b) CHECK_LT(a, b)
#define DCHECK_LE(a, b) CHECK_LE(a, b)
#define DCHECK_GT(a, b) CHECK_GT(a, b)
#define DCHECK_GE(a, b) CHECK_GE(a, b)
#define DCHECK_NOTNULL(pointer) CHECK_NOTNULL(pointer)
