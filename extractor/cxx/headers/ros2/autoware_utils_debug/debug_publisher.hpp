// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rclcpp/rclcpp.hpp>
namespace autoware_utils_debug {
template <class NodeT = rclcpp::Node> class BasicDebugPublisher { public:
  template <class N, class T> BasicDebugPublisher(N* node, const T& name_space);
  template <class M, class T, class... A> void publish(const T& name, const M& message, const A&... qos);
  template <class M, class T, class D, class... A> void publish(const T& name, const D& data, const A&... qos); };
using DebugPublisher = BasicDebugPublisher<rclcpp::Node>;
}
