// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
namespace sensor_msgs { namespace distortion_models { extern const std::string PLUMB_BOB, RATIONAL_POLYNOMIAL, EQUIDISTANT; } }
