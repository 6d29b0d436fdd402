// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/message_traits.h>
namespace ros {
class Subscriber {
public:
  Subscriber();
  Subscriber(const Subscriber&);
  ~Subscriber();
  Subscriber& operator=(const Subscriber&);
  void shutdown();
  std::string getTopic() const;
  uint32_t getNumPublishers() const;
  operator void*() const;
  bool operator==(const Subscriber&) const;
  bool operator!=(const Subscriber&) const;
  bool operator<(const Subscriber&) const;
};
typedef std::vector<Subscriber> V_Subscriber;
}
