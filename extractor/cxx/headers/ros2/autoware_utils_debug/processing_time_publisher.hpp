// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rclcpp/rclcpp.hpp>
namespace autoware_utils_debug { class ProcessingTimePublisher { public:
  template <class N> explicit ProcessingTimePublisher(N* node); template <class N, class T, class... A> ProcessingTimePublisher(N* node, const T& name, const A&... qos);
  template <class M> void publish(const M& times); }; }
