// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/message_traits.h>
namespace ros {
class ServiceServer {
public:
  ServiceServer();
  ServiceServer(const ServiceServer&);
  ~ServiceServer();
  ServiceServer& operator=(const ServiceServer&);
  void shutdown();
  std::string getService() const;
  operator void*() const;
  bool operator<(const ServiceServer&) const;
};
}
