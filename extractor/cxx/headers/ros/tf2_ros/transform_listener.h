// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <tf2_ros/buffer.h>
#include <ros/ros.h>
namespace tf2_ros {
class TransformListener { public: TransformListener(tf2::BufferCore& buffer, bool spin_thread = true);
  TransformListener(tf2::BufferCore& buffer, const ros::NodeHandle&, bool spin_thread = true); ~TransformListener(); };
}
