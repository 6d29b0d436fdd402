// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/ros.h>
namespace realtime_tools {
template <class M> class RealtimePublisher { public: M msg_; RealtimePublisher();
  RealtimePublisher(const ros::NodeHandle& node, const std::string& topic, int queue_size, bool latched = false); ~RealtimePublisher();
  void init(const ros::NodeHandle&, const std::string& topic, int queue_size, bool latched = false); void stop(); bool trylock();
  void lock(); void unlock(); void unlockAndPublish(); bool is_running() const; };
template <class T> class RealtimeBuffer { public: RealtimeBuffer(); RealtimeBuffer(const T&); T* readFromRT(); T* readFromNonRT() const;
  void writeFromNonRT(const T&); void initRT(const T&); void reset(); };
template <class T> class RealtimeBox { public: explicit RealtimeBox(const T& = T()); void set(const T&); void get(T&); };
template <class A> class RealtimeServerGoalHandle { public: template <class... X> RealtimeServerGoalHandle(const X&...); };
}
