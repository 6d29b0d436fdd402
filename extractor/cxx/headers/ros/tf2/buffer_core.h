// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <tf2/convert.h>
#include <tf2/exceptions.h>
#include <vector>
namespace tf2 {
class BufferCore {
public:
  BufferCore(ros::Duration cache_time = ros::Duration(10)); virtual ~BufferCore();
  void clear(); bool setTransform(const geometry_msgs::TransformStamped&, const std::string& authority, bool is_static = false);
  // (target, source, time[, timeout]) or (target, target time, source, source time, fixed[, timeout])
  template <class A, class B, class C, class... X> geometry_msgs::TransformStamped lookupTransform(const A&, const B&, const C&,
    const X&...) const;
  template <class A, class B, class C, class... X> bool canTransform(const A&, const B&, const C&, const X&...) const;
  std::string allFramesAsYAML(double = 0) const; std::string allFramesAsString() const; std::vector<std::string> getAllFrameNames() const;
    bool _frameExists(const std::string&) const; void _getFrameStrings(std::vector<std::string>&) const;
    bool isUsingDedicatedThread() const; void setUsingDedicatedThread(bool);
    bool _getParent(const std::string&, ros::Time, std::string&) const;
};
class BufferCoreInterface : public BufferCore {};
}
