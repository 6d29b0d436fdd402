// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <tf2/buffer_core.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>
namespace tf2_ros {
class BufferInterface {
public:
  virtual ~BufferInterface();
  template <class A, class B, class C, class... X> geometry_msgs::TransformStamped lookupTransform(const A&, const B&, const C&,
    const X&...) const;
  template <class A, class B, class C, class... X> bool canTransform(const A&, const B&, const C&, const X&...) const;
  template <class T, class Frame> T transform(const T&, const Frame&, ros::Duration = ros::Duration()) const;
  template <class A, class B, class Frame, class... X> B& transform(const A&, B&, const Frame&, const X&...) const;
};
class Buffer : public BufferInterface, public tf2::BufferCore {
public:
  Buffer(ros::Duration cache_time = ros::Duration(10), bool debug = false, ros::NodeHandle = ros::NodeHandle());
  template <class A, class B, class C, class... X> geometry_msgs::TransformStamped lookupTransform(const A&, const B&, const C&,
    const X&...) const;
  template <class A, class B, class C, class... X> bool canTransform(const A&, const B&, const C&, const X&...) const;
};
class BufferClient : public BufferInterface { public: template <class... A> BufferClient(const A&...);
  bool waitForServer(const ros::Duration& = ros::Duration(0)); };
class BufferServer { public: template <class... A> BufferServer(const BufferInterface&, const A&...); void start(); };
}
// their names before Hydro
namespace tf2 { using tf2_ros::Buffer; using tf2_ros::BufferClient; using tf2_ros::BufferInterface; using tf2_ros::BufferServer; }
