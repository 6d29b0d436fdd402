// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <hardware_interface/robot_hw.h>
#include <urdf/model.h>
namespace joint_limits_interface {
struct JointLimits { double min_position, max_position, max_velocity, max_acceleration, max_jerk, max_effort;
  bool has_position_limits, has_velocity_limits, has_acceleration_limits, has_jerk_limits, has_effort_limits, angle_wraparound; };
  struct SoftJointLimits { double min_position, max_position, k_position, k_velocity; };
template <class J> bool getJointLimits(const J&, JointLimits&);
  bool getJointLimits(const std::string&, const ros::NodeHandle&, JointLimits&);
  template <class J> bool getSoftJointLimits(const J&, SoftJointLimits&);
#define ROSARCH_LIMITS(Name) class Name##Handle { public: template <class... A> Name##Handle(const A&...); \
  void enforceLimits(const ros::Duration&); }; \
  class Name##Interface : public hardware_interface::HardwareResourceManager<Name##Handle> { public: void enforceLimits(const \
  ros::Duration&); };
ROSARCH_LIMITS(PositionJointSaturation) ROSARCH_LIMITS(PositionJointSoftLimits) ROSARCH_LIMITS(VelocityJointSaturation)
  ROSARCH_LIMITS(VelocityJointSoftLimits) ROSARCH_LIMITS(EffortJointSaturation) ROSARCH_LIMITS(EffortJointSoftLimits)
#undef ROSARCH_LIMITS
}
