// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <geometry_msgs/TransformStamped.h>
#include <ros/ros.h>
namespace tf2_ros { class StaticTransformBroadcaster { public: StaticTransformBroadcaster();
  template <class T> void sendTransform(const T& transform); }; }
