// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <autoware_internal_debug_msgs/msg/processing_time_tree.hpp>
#include <rclcpp/rclcpp.hpp>
namespace autoware_utils_debug {
using ProcessingTimeDetail = autoware_internal_debug_msgs::msg::ProcessingTimeTree;
class TimeKeeper { public:
  template <class... A> explicit TimeKeeper(const A&... reporters); template <class A> void add_reporter(const A& reporter);
  void start_track(const std::string& name); void end_track(const std::string& name); void comment(const std::string& text); };
class ScopedTimeTrack { public: ScopedTimeTrack(const std::string& name, TimeKeeper& keeper); ~ScopedTimeTrack(); };
}
