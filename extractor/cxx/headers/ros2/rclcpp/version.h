// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rclcpp/rclcpp.hpp>
// the newest: of what sources have for several, that is read which is for it
#define RCLCPP_VERSION_MAJOR 31
#define RCLCPP_VERSION_MINOR 0
#define RCLCPP_VERSION_PATCH 0
#define RCLCPP_VERSION_STR "31.0.0"
#define RCLCPP_VERSION_GTE(major, minor, patch) \
  (major < RCLCPP_VERSION_MAJOR || (major == RCLCPP_VERSION_MAJOR && (minor < RCLCPP_VERSION_MINOR || (minor == RCLCPP_VERSION_MINOR && patch <= RCLCPP_VERSION_PATCH))))
