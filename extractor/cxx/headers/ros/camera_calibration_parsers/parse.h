// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sensor_msgs/CameraInfo.h>
namespace camera_calibration_parsers { bool writeCalibration(const std::string&, const std::string&, const sensor_msgs::CameraInfo&);
  bool readCalibration(const std::string&, std::string&, sensor_msgs::CameraInfo&);
  bool readCalibrationYml(const std::string&, std::string&, sensor_msgs::CameraInfo&); }
