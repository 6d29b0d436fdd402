// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/publisher.h>
#include <ros/subscriber.h>
#include <ros/service_server.h>
#include <ros/service_client.h>
#include <ros/subscribe_options.h>
#include <ros/timer.h>
#include <ros/rate.h>
#include <ros/exceptions.h>
#include <rosarch/any.h>
#include <xmlrpcpp/XmlRpcValue.h>
#include <boost/bind.hpp>
namespace ros {
// The result of param<T>(name, default): T when given, else the type of the default.
template <class T, class Default> struct rosarch_param { typedef T type; };
template <class Default> struct rosarch_param<void, Default> { typedef typename std::decay<Default>::type type; };

// Names, results and order of arguments are the real ones. Parameter types are free: no argument is converted, no two
// arguments have to agree, and an argument of unknown type does not lose the call. The template parameters that come
// first and default to void take the explicit arguments (`subscribe<M>`, `advertiseService<Req, Res>`).
class NodeHandle {
public:
  NodeHandle(const std::string& ns = std::string(), const M_string& remappings = M_string());
  NodeHandle(const NodeHandle&);
  NodeHandle(const NodeHandle& parent, const std::string& ns);
  NodeHandle(const NodeHandle& parent, const std::string& ns, const M_string& remappings);
  ~NodeHandle();
  NodeHandle& operator=(const NodeHandle&);

  // (topic, queue_size, latch) or (topic, queue_size, connect, disconnect, tracked, latch)
  template <class M, class Topic, class Queue, class... A> Publisher advertise(const Topic& topic, const Queue& queue_size, const A&...);
  Publisher advertise(AdvertiseOptions&);

  // (topic, queue_size, callback[, object or tracked][, hints]), for every kind of callback
  template <class M = void, class T = void, class Topic, class Queue, class F, class... A> Subscriber subscribe(const Topic& topic,
    const Queue& queue_size, const F& callback, const A&...);
  // The same for an overloaded callback, which only the explicit message type tells apart.
  template <class M, class T> Subscriber subscribe(const std::string& topic, uint32_t queue_size, void (T::*callback)(M),
    const rosarch::any& object, const TransportHints& = TransportHints());
  template <class M, class T> Subscriber subscribe(const std::string& topic, uint32_t queue_size,
    void (T::*callback)(const boost::shared_ptr<const M>&), const rosarch::any& object, const TransportHints& = TransportHints());
  template <class M> Subscriber subscribe(const std::string& topic, uint32_t queue_size, void (*callback)(M),
    const TransportHints& = TransportHints());
  template <class M> Subscriber subscribe(const std::string& topic, uint32_t queue_size,
    void (*callback)(const boost::shared_ptr<const M>&), const TransportHints& = TransportHints());
  Subscriber subscribe(SubscribeOptions&);

  // (service, callback[, object or tracked])
  template <class A = void, class B = void, class C = void, class Service, class F,
    class... X> ServiceServer advertiseService(const Service& service, const F& callback, const X&...);
  template <class T, class Request, class Response> ServiceServer advertiseService(const std::string& service, bool (T::*callback)(Request&,
    Response&), const rosarch::any& object);
  ServiceServer advertiseService(AdvertiseServiceOptions&);

  // (service, persistent, header)
  template <class S, class Service, class... A> ServiceClient serviceClient(const Service& service, const A&...);
  template <class Request, class Response, class Service, class... A> ServiceClient serviceClient(const Service& service, const A&...);
  ServiceClient serviceClient(ServiceClientOptions&);

  // (period, callback[, object or tracked][, oneshot][, autostart])
  template <class Period, class F, class... A> Timer createTimer(const Period& period, const F& callback, const A&...) const;
  template <class Period, class T, class... A> Timer createTimer(const Period& period, void (T::*callback)(const TimerEvent&), T* object,
    const A&...) const;
  Timer createTimer(TimerOptions&) const;
  template <class Period, class F, class... A> WallTimer createWallTimer(const Period& period, const F& callback, const A&...) const;
  template <class Period, class T, class... A> WallTimer createWallTimer(const Period& period, void (T::*callback)(const WallTimerEvent&),
    T* object, const A&...) const;
  WallTimer createWallTimer(WallTimerOptions&) const;
  template <class Period, class F, class... A> SteadyTimer createSteadyTimer(const Period& period, const F& callback, const A&...) const;
  SteadyTimer createSteadyTimer(SteadyTimerOptions&) const;

  template <class Key, class V> bool getParam(const Key& key, V&& value) const;
  template <class Key, class V> bool getParamCached(const Key& key, V&& value) const;
  template <class Key, class V> void setParam(const Key& key, const V& value) const;
  template <class Key> bool hasParam(const Key& key) const;
  template <class Key> bool deleteParam(const Key& key) const;
  template <class Key> bool searchParam(const Key& key, std::string& result) const;
  bool getParamNames(std::vector<std::string>& keys) const;
  // The variable is a forwarding reference: elements of vector<bool> and other proxies are accepted. A braced default has its type.
  template <class T = void, class Key, class V, class Default = typename std::decay<V>::type> bool param(const Key& key, V&& variable,
    const Default& default_value) const;
  template <class T = void, class Key, class Default> typename rosarch_param<T, Default>::type param(const Key& key,
    const Default& default_value) const;

  const std::string& getNamespace() const;
  const std::string& getUnresolvedNamespace() const;
  std::string resolveName(const std::string& name, bool remap = true) const;
  void setCallbackQueue(CallbackQueueInterface*);
  CallbackQueueInterface* getCallbackQueue() const;
  void shutdown();
  bool ok() const;
};
typedef boost::shared_ptr<NodeHandle> NodeHandlePtr;
}
