// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <pcl_ros/point_cloud.h>
namespace pcl_ros { template <class T> class Publisher : public ros::Publisher { public: void advertise(ros::NodeHandle&,
  const std::string& topic, uint32_t queue_size, bool latch = false); }; class PCLNodelet {}; }
