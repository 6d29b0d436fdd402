// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rclcpp/rosarch_time.hpp>
#include <rclcpp/rosarch_qos.hpp>
#include <rclcpp/rosarch_parameters.hpp>
#include <rclcpp/rosarch_node.hpp>
#include <rclcpp/rosarch_executors.hpp>
