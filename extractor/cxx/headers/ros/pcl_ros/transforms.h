// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <pcl_conversions/pcl_conversions.h>
#include <tf/transform_datatypes.h>
#include <tf/transform_listener.h>
#include <Eigen/Geometry>
namespace pcl_ros { template <class A, class B, class... X> bool transformPointCloud(const A&, const B&, X&&...);
  template <class A, class B, class... X> bool transformPointCloudWithNormals(const A&, const B&, X&&...);
  void transformAsMatrix(const tf::Transform&, Eigen::Matrix4f&); }
