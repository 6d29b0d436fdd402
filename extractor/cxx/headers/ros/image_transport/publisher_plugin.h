// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <image_transport/image_transport.h>
namespace image_transport { class PublisherPlugin { public: virtual ~PublisherPlugin(); virtual std::string getTransportName() const;
  virtual void publish(const sensor_msgs::Image&) const; }; template <class M> class SimplePublisherPlugin : public PublisherPlugin {};
  class SubscriberPlugin { public: virtual ~SubscriberPlugin(); };
  template <class M> class SimpleSubscriberPlugin : public SubscriberPlugin {}; }
