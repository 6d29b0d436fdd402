// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <controller_interface/controller.h>
namespace controller_manager { class ControllerManager { public: ControllerManager(hardware_interface::RobotHW*,
  const ros::NodeHandle& = ros::NodeHandle()); void update(const ros::Time&, const ros::Duration&, bool = false);
  bool loadController(const std::string&); bool unloadController(const std::string&);
  controller_interface::ControllerBase* getControllerByName(const std::string&); }; }
