// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <message_filters/connection.h>
#include <message_filters/null_types.h>
#include <ros/message_event.h>
#include <rosarch/any.h>
namespace message_filters {
// Time policies and synchronizers keep their message types as template arguments.
template <class... M> struct rosarch_policy {
  void setMaxIntervalDuration(ros::Duration); void setAgePenalty(double); template <class... A> void setInterMessageLowerBound(const A&...);
};
template <class Policy> class Synchronizer : public Policy {
public:
  Synchronizer(); template <class... A> explicit Synchronizer(A&&...);
  template <class... F> void connectInput(F&...);
  template <class F, class... A> Connection registerCallback(const F& callback, const A&...);
  template <class P> void init(const P&); void setName(const std::string&); const std::string& getName(); Policy* getPolicy();
    template <int i, class X> void add(const X&);
};
}
