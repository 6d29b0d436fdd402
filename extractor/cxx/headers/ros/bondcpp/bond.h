// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/ros.h>
namespace bond { class Bond { public: template <class... A> Bond(const std::string& topic, const std::string& id, const A&...);
  void start(); void breakBond(); bool isBroken(); bool waitUntilFormed(ros::Duration = ros::Duration(-1));
  bool waitUntilBroken(ros::Duration = ros::Duration(-1)); template <class F> void setBrokenCallback(const F&);
  template <class F> void setFormedCallback(const F&); void setCallbackQueue(ros::CallbackQueueInterface*); }; }
