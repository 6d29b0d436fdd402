// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/Image.h>
#include <ros/ros.h>
namespace pcl_conversions { template <class A, class B> void toPCL(const A&, B&); template <class A, class B> void fromPCL(const A&, B&);
  template <class A, class B> void copyPointCloud2MetaData(const A&, B&);
  template <class A, class B> void copyPCLPointCloud2MetaData(const A&, B&); template <class A, class B> void moveToPCL(A&, B&);
  template <class A, class B> void moveFromPCL(A&, B&); pcl::PCLHeader toPCL(const std_msgs::Header&);
  std_msgs::Header fromPCL(const pcl::PCLHeader&); uint64_t toPCL(const ros::Time&); ros::Time fromPCL(const uint64_t&); }
namespace pcl { bool concatenatePointCloud(const sensor_msgs::PointCloud2&, const sensor_msgs::PointCloud2&, sensor_msgs::PointCloud2&); }
