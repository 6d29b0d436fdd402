// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/message_traits.h>
namespace ros {
class ServiceClient {
public:
  ServiceClient();
  ServiceClient(const ServiceClient&);
  ~ServiceClient();
  ServiceClient& operator=(const ServiceClient&);
  template <class Service> bool call(Service& service);
  template <class Request, class Response> bool call(const Request& request, Response& response);
  template <class Request, class Response> bool call(const Request&, Response&, const std::string& md5sum);
  bool waitForExistence(Duration timeout = Duration(-1));
  bool exists();
  bool isPersistent() const;
  bool isValid() const;
  void shutdown();
  std::string getService();
  operator void*() const;
  bool operator==(const ServiceClient&) const;
  bool operator!=(const ServiceClient&) const;
  bool operator<(const ServiceClient&) const;
};
typedef boost::shared_ptr<ServiceClient> ServiceClientPtr;
}
