// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <message_filters/simple_filter.h>
#include <vector>
namespace message_filters {
template <class M> class Cache : public SimpleFilter<M> { public: Cache(unsigned = 1); template <class F> Cache(F&, unsigned = 1);
  template <class F> void connectInput(F&); void setCacheSize(unsigned); void add(const boost::shared_ptr<const M>&);
  std::vector<boost::shared_ptr<const M>> getInterval(const ros::Time&, const ros::Time&) const;
  boost::shared_ptr<const M> getElemBeforeTime(const ros::Time&) const; boost::shared_ptr<const M> getElemAfterTime(const ros::Time&) const;
  ros::Time getLatestTime() const; ros::Time getOldestTime() const; };
template <class M> class PassThrough : public SimpleFilter<M> { public: PassThrough(); template <class F> PassThrough(F&);
  template <class F> void connectInput(F&); template <class X> void add(const X&); };
template <class M> class TimeSequencer : public SimpleFilter<M> { public: template <class... A> TimeSequencer(A&&...);
  template <class F> void connectInput(F&); };
template <class M> class Chain : public SimpleFilter<M> { public: Chain(); template <class F> Chain(F&);
  template <class F> std::size_t addFilter(F&&); };
}
