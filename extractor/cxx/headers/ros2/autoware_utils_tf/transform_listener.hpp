// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <tf2_ros/buffer.hpp>
namespace autoware_utils_tf { class TransformListener { public: RCLCPP_POINTERS(TransformListener) template <class N> explicit TransformListener(N* node); geometry_msgs::msg::TransformStamped::ConstSharedPtr get_latest_transform(const std::string& from, const std::string& to);
  template <class T, class D> geometry_msgs::msg::TransformStamped::ConstSharedPtr get_transform(const std::string& from, const std::string& to, const T& time, const D& duration); rclcpp::Logger get_logger(); }; }
