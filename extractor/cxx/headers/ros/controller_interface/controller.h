// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <hardware_interface/robot_hw.h>
namespace controller_interface {
class ControllerBase { public: ControllerBase(); virtual ~ControllerBase(); virtual void starting(const ros::Time&);
  virtual void update(const ros::Time&, const ros::Duration&) = 0; virtual void stopping(const ros::Time&); bool isRunning();
  enum { CONSTRUCTED, INITIALIZED, RUNNING } state_; };
template <class T> class Controller : public ControllerBase { public: virtual bool init(T*, ros::NodeHandle&);
  virtual bool init(T*, ros::NodeHandle&, ros::NodeHandle&); protected: std::string getHardwareInterfaceType() const; };
template <class... T> class MultiInterfaceController : public ControllerBase { public: MultiInterfaceController(bool = false);
  virtual bool init(hardware_interface::RobotHW*, ros::NodeHandle&);
  virtual bool init(hardware_interface::RobotHW*, ros::NodeHandle&, ros::NodeHandle&); };
}
