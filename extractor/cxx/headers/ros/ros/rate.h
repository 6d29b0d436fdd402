// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/duration.h>
namespace ros {
class Rate {
public:
  Rate(double frequency);
  explicit Rate(const Duration&);
  bool sleep();
  void reset();
  Duration cycleTime() const;
  Duration expectedCycleTime() const;
};
class WallRate {
public:
  WallRate(double frequency);
  explicit WallRate(const Duration&);
  bool sleep();
  void reset();
  WallDuration cycleTime() const;
  WallDuration expectedCycleTime();
};
class LoopRate;
}
