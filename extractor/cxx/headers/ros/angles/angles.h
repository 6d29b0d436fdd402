// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
namespace angles { double from_degrees(double); double to_degrees(double); double normalize_angle_positive(double);
  double normalize_angle(double); double shortest_angular_distance(double, double); double two_pi_complement(double);
  bool find_min_max_delta(double, double, double, double&, double&);
  bool shortest_angular_distance_with_limits(double, double, double, double, double&); }
