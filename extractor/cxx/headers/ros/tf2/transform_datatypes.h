// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <tf2/LinearMath/Transform.h>
#include <ros/time.h>
#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PointStamped.h>
#include <geometry_msgs/QuaternionStamped.h>
#include <geometry_msgs/Vector3Stamped.h>
namespace tf2 { template <class T> class Stamped : public T { public: ros::Time stamp_; std::string frame_id_; Stamped();
  Stamped(const T&, const ros::Time&, const std::string&); void setData(const T&); bool operator==(const Stamped&) const; }; }
