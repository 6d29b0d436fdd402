// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
namespace camera_info_manager { class CameraInfoManager { public: CameraInfoManager(ros::NodeHandle, const std::string& = "camera",
  const std::string& = ""); sensor_msgs::CameraInfo getCameraInfo(); bool isCalibrated(); bool loadCameraInfo(const std::string&);
  bool setCameraInfo(const sensor_msgs::CameraInfo&); bool setCameraName(const std::string&); bool validateURL(const std::string&);
  std::string resolveURL(const std::string&, const std::string&); }; }
