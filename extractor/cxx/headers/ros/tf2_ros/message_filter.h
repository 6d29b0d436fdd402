// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/ros.h>
#include <tf2_ros/buffer.h>
#include <message_filters/subscriber.h>
namespace tf2_ros {
namespace filter_failure_reasons { enum FilterFailureReason { Unknown, OutTheBack, EmptyFrameID }; }
typedef filter_failure_reasons::FilterFailureReason FilterFailureReason;
class MessageFilterBase { public: virtual ~MessageFilterBase(); virtual void clear(); virtual void setTargetFrame(const std::string&);
  virtual void setTargetFrames(const std::vector<std::string>&); virtual void setTolerance(const ros::Duration&); };
template <class M> class MessageFilter : public MessageFilterBase, public message_filters::SimpleFilter<M> {
public:
  typedef boost::shared_ptr<const M> MConstPtr;
  template <class... A> MessageFilter(A&&...);
  template <class F> void connectInput(F&); void setQueueSize(uint32_t); std::string getTargetFramesString();
    template <class X> void add(const X&);
  template <class... A> message_filters::Connection registerFailureCallback(const A&...);
};
}
