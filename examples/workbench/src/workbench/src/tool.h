#pragma once

#include <ros/ros.h>

namespace workbench
{
class Tool
{
public:
  virtual ~Tool() = default;
  virtual void initialize(ros::NodeHandle& nh) = 0;
};
}  // namespace workbench
