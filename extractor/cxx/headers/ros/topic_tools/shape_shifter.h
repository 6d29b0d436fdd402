// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/ros.h>
namespace topic_tools { class ShapeShifter { public: typedef boost::shared_ptr<ShapeShifter> Ptr;
  typedef boost::shared_ptr<const ShapeShifter> ConstPtr; const std::string& getDataType() const; const std::string& getMD5Sum() const;
  const std::string& getMessageDefinition() const;
  void morph(const std::string&, const std::string&, const std::string&, const std::string&);
  template <class... A> ros::Publisher advertise(ros::NodeHandle&, const std::string& topic, uint32_t queue, const A&...) const;
  template <class M> boost::shared_ptr<M> instantiate() const; template <class S> void write(S&) const; template <class S> void read(S&);
  uint32_t size() const; }; bool getBaseName(const std::string&, std::string&); }
