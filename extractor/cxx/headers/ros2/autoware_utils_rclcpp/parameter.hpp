// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rclcpp/rclcpp.hpp>
namespace autoware_utils_rclcpp { template <class T, class N, class Name> T get_or_declare_parameter(N& node, const Name& name); template <class T, class Params, class Name> bool update_param(const Params& params, const Name& name, T& value); }
