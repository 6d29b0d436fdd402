// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sensor_msgs/PointCloud.h>
#include <sensor_msgs/PointCloud2.h>
namespace sensor_msgs { bool convertPointCloudToPointCloud2(const PointCloud&, PointCloud2&);
  bool convertPointCloud2ToPointCloud(const PointCloud2&, PointCloud&);
  int getPointCloud2FieldIndex(const PointCloud2&, const std::string&); }
