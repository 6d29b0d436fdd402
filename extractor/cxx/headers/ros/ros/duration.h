// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <stdexcept>
#include <iosfwd>
namespace boost { namespace posix_time { class time_duration; class ptime; } }
namespace ros {
class Rate;
class WallRate;
// Members are those of DurationBase in the real interface; here each class declares them itself.
#define ROSARCH_DURATION(Self) \
public: \
  int32_t sec, nsec; \
  Self(); \
  explicit Self(double); \
  Self(int32_t, int32_t); \
  Self& fromSec(double); \
  Self& fromNSec(int64_t); \
  double toSec() const; \
  int64_t toNSec() const; \
  bool isZero() const; \
  boost::posix_time::time_duration toBoost() const; \
  bool sleep() const; \
  Self operator+(const Self&) const; \
  Self operator-(const Self&) const; \
  Self operator-() const; \
  Self operator*(double) const; \
  Self& operator+=(const Self&); \
  Self& operator-=(const Self&); \
  Self& operator*=(double); \
  bool operator==(const Self&) const; \
  bool operator!=(const Self&) const; \
  bool operator<(const Self&) const; \
  bool operator>(const Self&) const; \
  bool operator<=(const Self&) const; \
  bool operator>=(const Self&) const; \
  static const Self ZERO, MIN, MAX, DAY, HOUR, MINUTE, SECOND, MILLISECOND, MICROSECOND, NANOSECOND;
class Duration { ROSARCH_DURATION(Duration) explicit Duration(const Rate&); };
class WallDuration { ROSARCH_DURATION(WallDuration) explicit WallDuration(const Rate&); explicit WallDuration(const WallRate&); };
#undef ROSARCH_DURATION
extern const Duration DURATION_MAX, DURATION_MIN;
}
