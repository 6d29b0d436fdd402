// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/message_traits.h>
#include <boost/function.hpp>
namespace ros {
class SingleSubscriberPublisher { public: template <class M> void publish(const M&) const; std::string getTopic() const;
  std::string getSubscriberName() const; };
typedef boost::function<void(const SingleSubscriberPublisher&)> SubscriberStatusCallback;
}
