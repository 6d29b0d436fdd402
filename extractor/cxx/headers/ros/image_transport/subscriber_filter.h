// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <image_transport/image_transport.h>
#include <message_filters/simple_filter.h>
namespace image_transport { class SubscriberFilter : public message_filters::SimpleFilter<sensor_msgs::Image> { public: SubscriberFilter();
  template <class... A> SubscriberFilter(ImageTransport&, const A&...); template <class... A> void subscribe(ImageTransport&, const A&...);
  void unsubscribe(); std::string getTopic() const; uint32_t getNumPublishers() const; const Subscriber& getSubscriber() const; }; }
