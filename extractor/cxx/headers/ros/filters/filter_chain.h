// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/ros.h>
namespace filters { template <class T> class FilterBase { public: virtual ~FilterBase(); virtual bool configure();
  virtual bool update(const T&, T&) = 0; const std::string& getName(); template <class V> bool getParam(const std::string&, V&); };
  template <class T> class FilterChain { public: FilterChain(const std::string&);
  bool configure(const std::string&, ros::NodeHandle = ros::NodeHandle()); bool update(const T&, T&); void clear(); };
  template <class T> class MultiChannelFilterBase : public FilterBase<T> {};
  template <class T> class MultiChannelFilterChain : public FilterChain<T> { public: MultiChannelFilterChain(const std::string&);
  bool configure(unsigned, const std::string&, ros::NodeHandle = ros::NodeHandle()); }; }
