// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/single_subscriber_publisher.h>
namespace ros {
class Publisher {
public:
  Publisher();
  Publisher(const Publisher&);
  ~Publisher();
  Publisher& operator=(const Publisher&);
  template <class M> void publish(const M& message) const;
  void shutdown();
  std::string getTopic() const;
  uint32_t getNumSubscribers() const;
  bool isLatched() const;
  operator void*() const;
  bool operator==(const Publisher&) const;
  bool operator!=(const Publisher&) const;
  bool operator<(const Publisher&) const;
};
typedef std::vector<Publisher> V_Publisher;
}
