// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <message_filters/connection.h>
#include <ros/message_event.h>
#include <rosarch/any.h>
namespace message_filters {
template <class M> class SimpleFilter {
public:
  // (callback[, object])
  template <class F, class... A> Connection registerCallback(const F& callback, const A&...);
  template <class T> Connection registerCallback(void (T::*callback)(const boost::shared_ptr<const M>&), const rosarch::any& object);
  void setName(const std::string&); const std::string& getName();
  template <class X> void signalMessage(const X&);
};
}
