// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/duration.h>
#include <ros/rate.h>
namespace ros {
class TimeNotInitializedException : public std::runtime_error { public: TimeNotInitializedException(); };
class NoHighPerformanceTimersException : public std::runtime_error { public: NoHighPerformanceTimersException(); };
// Members are those of TimeBase in the real interface; here each class declares them itself.
#define ROSARCH_TIME(Self, Difference) \
public: \
  uint32_t sec, nsec; \
  Self(); \
  Self(uint32_t, uint32_t); \
  explicit Self(double); \
  static Self now(); \
  static bool sleepUntil(const Self&); \
  static bool isSystemTime(); \
  double toSec() const; \
  uint64_t toNSec() const; \
  Self& fromSec(double); \
  Self& fromNSec(uint64_t); \
  bool isZero() const; \
  bool is_zero() const; \
  Difference operator-(const Self&) const; \
  Self operator+(const Difference&) const; \
  Self operator-(const Difference&) const; \
  Self& operator+=(const Difference&); \
  Self& operator-=(const Difference&); \
  bool operator==(const Self&) const; \
  bool operator!=(const Self&) const; \
  bool operator<(const Self&) const; \
  bool operator>(const Self&) const; \
  bool operator<=(const Self&) const; \
  bool operator>=(const Self&) const; \
  static const Self MIN, MAX, ZERO, UNINITIALIZED;
class Time {
  ROSARCH_TIME(Time, Duration)
  static void init();
  static void shutdown();
  static void setNow(const Time&);
  static bool useSystemTime();
  static bool isSimTime();
  static bool isValid();
  static bool waitForValid();
  static bool waitForValid(const WallDuration&);
  boost::posix_time::ptime toBoost() const;
  static Time fromBoost(const boost::posix_time::ptime&);
  static Time fromBoost(const boost::posix_time::time_duration&);
};
class WallTime { ROSARCH_TIME(WallTime, WallDuration) };
class SteadyTime { ROSARCH_TIME(SteadyTime, WallDuration) };
#undef ROSARCH_TIME
extern const Time TIME_MAX, TIME_MIN;
}
