// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sensor_msgs/Image.h>
namespace sensor_msgs { bool fillImage(Image&, const std::string&, uint32_t, uint32_t, uint32_t, const void*); void clearImage(Image&); }
