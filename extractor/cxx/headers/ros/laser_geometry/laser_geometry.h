// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/PointCloud.h>
#include <tf/tf.h>
namespace laser_geometry { namespace channel_option { enum ChannelOption { None = 0, Intensity = 1, Index = 2, Distance = 4, Timestamp = 8,
  Viewpoint = 16, Default = 3 }; } class LaserProjection { public: template <class C,
  class... A> void projectLaser(const sensor_msgs::LaserScan& scan, C& cloud, const A&...);
  template <class Frame, class C, class T, class... A> void transformLaserScanToPointCloud(const Frame& target,
  const sensor_msgs::LaserScan& scan, C& cloud, T& tf, const A&...); }; }
