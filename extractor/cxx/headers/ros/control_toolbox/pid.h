// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/ros.h>
namespace control_toolbox { class Pid { public: struct Gains { double p_gain_, i_gain_, d_gain_, i_max_, i_min_; bool antiwindup_; };
  Pid(double = 0, double = 0, double = 0, double = 0, double = 0, bool = false); template <class... A> bool init(const A&...);
  bool initParam(const std::string&, bool = false); template <class... A> void initPid(const A&...); void reset();
  template <class... A> double computeCommand(double, const A&...); template <class... A> double updatePid(double, const A&...);
  template <class... A> void getGains(A&...); template <class... A> void setGains(const A&...); double getCurrentCmd();
  void setCurrentCmd(double); }; }
