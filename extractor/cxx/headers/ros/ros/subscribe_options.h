// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/transport_hints.h>
#include <ros/message_event.h>
#include <ros/callback_queue.h>
#include <boost/function.hpp>
namespace ros {
class SubscriptionCallbackHelper;
typedef boost::shared_ptr<SubscriptionCallbackHelper> SubscriptionCallbackHelperPtr;
struct SubscribeOptions {
  SubscribeOptions();
  template <class... A> SubscribeOptions(const std::string& topic, const A&...);
  template <class P = void, class... A> void initByFullCallbackType(const A&...);
  template <class M = void, class... A> void init(const A&...);
  template <class M = void, class... A> static SubscribeOptions create(const A&...);
  std::string topic; uint32_t queue_size; std::string md5sum; std::string datatype; SubscriptionCallbackHelperPtr helper;
  CallbackQueueInterface* callback_queue; bool allow_concurrent_callbacks; VoidConstPtr tracked_object; TransportHints transport_hints;
};
struct AdvertiseOptions {
  AdvertiseOptions();
  template <class... A> AdvertiseOptions(const std::string& topic, const A&...);
  template <class M, class... A> void init(const A&...);
  template <class M, class... A> static AdvertiseOptions create(const A&...);
  std::string topic; uint32_t queue_size; std::string md5sum; std::string datatype; std::string message_definition;
  boost::function<void(const class SingleSubscriberPublisher&)> connect_cb, disconnect_cb;
  CallbackQueueInterface* callback_queue; VoidConstPtr tracked_object; bool latch; bool has_header;
};
struct AdvertiseServiceOptions {
  AdvertiseServiceOptions();
  template <class S = void, class R = void, class... A> void init(const A&...);
  template <class S = void, class... A> void initBySpecType(const A&...);
  template <class S = void, class... A> static AdvertiseServiceOptions create(const A&...);
  std::string service; std::string md5sum; std::string datatype; std::string req_datatype; std::string res_datatype;
    CallbackQueueInterface* callback_queue; VoidConstPtr tracked_object;
};
struct ServiceClientOptions { ServiceClientOptions(); template <class... A> ServiceClientOptions(const std::string&, const A&...);
  std::string service; std::string md5sum; bool persistent; M_string header; };
template <class Request, class Response> class ServiceEvent {
public:
  typedef Request RequestType; typedef Response ResponseType;
  const Request& getRequest() const; Response& getResponse() const; M_string& getConnectionHeader() const;
    const std::string& getCallerName() const;
};
}
