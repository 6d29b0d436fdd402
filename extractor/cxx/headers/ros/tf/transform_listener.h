// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <tf/tf.h>
#include <tf2_ros/transform_listener.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PointStamped.h>
#include <geometry_msgs/Vector3Stamped.h>
#include <geometry_msgs/QuaternionStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <sensor_msgs/PointCloud.h>
#include <std_srvs/Empty.h>
#include <ros/ros.h>
namespace tf {
std::string remap(const std::string& frame);
class TransformListener : public Transformer {
public:
  TransformListener(ros::Duration max_cache_time = ros::Duration(), bool spin_thread = true);
  TransformListener(const ros::NodeHandle&, ros::Duration max_cache_time = ros::Duration(), bool spin_thread = true);
  bool ok() const;
  std::string resolve(const std::string&);
};
}
