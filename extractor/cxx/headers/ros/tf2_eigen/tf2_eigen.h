// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <tf2/convert.h>
#include <geometry_msgs/Twist.h>
#include <geometry_msgs/Pose.h>
#include <Eigen/Geometry>
namespace tf2 {
Eigen::Isometry3d transformToEigen(const geometry_msgs::Transform&);
  Eigen::Isometry3d transformToEigen(const geometry_msgs::TransformStamped&);
  template <class T> geometry_msgs::TransformStamped eigenToTransform(const T&);
geometry_msgs::Point toMsg(const Eigen::Vector3d&); geometry_msgs::Quaternion toMsg(const Eigen::Quaterniond&);
  geometry_msgs::Pose toMsg(const Eigen::Affine3d&); geometry_msgs::Pose toMsg(const Eigen::Isometry3d&);
  geometry_msgs::Twist toMsg(const Eigen::Matrix<double, 6, 1>&);
}
