// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <tf/tf.h>
#include <geometry_msgs/TransformStamped.h>
#include <ros/ros.h>
namespace tf {
class TransformBroadcaster {
public:
  TransformBroadcaster();
  // A StampedTransform, a geometry_msgs::TransformStamped or a vector of either
  template <class T> void sendTransform(const T& transform);
};
}
