// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rclcpp/rclcpp.hpp>
#include <rclcpp_lifecycle/lifecycle_node.hpp>
namespace message_filters {
class Connection { public: Connection(); template <class... A> explicit Connection(const A&...); void disconnect(); };
struct NullType {};
template <class M> class MessageEvent { public: const std::shared_ptr<M>& getMessage() const; const std::shared_ptr<M>& getConstMessage() const; rclcpp::Time getReceiptTime() const; };
template <class M> class SimpleFilter { public:
  template <class F, class... A> Connection registerCallback(const F& callback, const A&... object);
  template <class T> Connection registerCallback(void (T::*callback)(const std::shared_ptr<const M>&), const rosarch::any& object);
  void setName(const std::string&); const std::string& getName(); template <class X> void signalMessage(const X&); };
template <class N = rclcpp::Node> class SubscriberBase { public: typedef std::shared_ptr<N> NodePtr; virtual ~SubscriberBase(); virtual void unsubscribe(); virtual void subscribe(); };
template <class M, class N = rclcpp::Node> class Subscriber : public SubscriberBase<N>, public SimpleFilter<M> { public: RCLCPP_POINTERS(Subscriber)
  typedef M MessageType; typedef MessageEvent<M const> EventType;
  Subscriber();
  // (node, topic[, qos[, options]])
  template <class Node, class Topic, class... A> Subscriber(const Node& node, const Topic& topic, const A&... qos_and_options);
  void subscribe() override; void unsubscribe() override;
  template <class Node, class Topic, class... A> void subscribe(const Node& node, const Topic& topic, const A&... qos_and_options);
  std::string getTopic() const; const std::shared_ptr<rclcpp::Subscription<M>> getSubscriber() const; template <class F> void connectInput(F&); template <class X> void add(const X&); };
template <class... M> struct rosarch_policy { template <class T> void setMaxIntervalDuration(const T&); void setAgePenalty(double); template <class... A> void setInterMessageLowerBound(const A&...); };
template <class Policy> class Synchronizer : public Policy { public: RCLCPP_POINTERS(Synchronizer) Synchronizer(); template <class... A> explicit Synchronizer(A&&...);
  template <class... F> void connectInput(F&...); template <class F, class... A> Connection registerCallback(const F& callback, const A&... object); template <class P> void init(const P&);
  void setName(const std::string&); const std::string& getName(); Policy* getPolicy(); template <int i, class X> void add(const X&); };
namespace sync_policies {
template <class... M> struct ApproximateTime : rosarch_policy<M...> { ApproximateTime(); ApproximateTime(uint32_t queue_size); };
template <class... M> struct ApproximateEpsilonTime : rosarch_policy<M...> { template <class T> ApproximateEpsilonTime(uint32_t queue_size, const T&); };
template <class... M> struct ExactTime : rosarch_policy<M...> { ExactTime(); ExactTime(uint32_t queue_size); template <class... A> Connection registerDropCallback(const A&...); };
template <class... M> struct LatestTime : rosarch_policy<M...> { LatestTime(); template <class... A> LatestTime(const A&...); };
}
template <class... M> class TimeSynchronizer : public Synchronizer<sync_policies::ExactTime<M...>> { public: RCLCPP_POINTERS(TimeSynchronizer) TimeSynchronizer(uint32_t queue_size);
  template <class... A> explicit TimeSynchronizer(A&&...); };
template <class M> class Cache : public SimpleFilter<M> { public: template <class... A> Cache(A&&...); template <class F> void connectInput(F&); void setCacheSize(unsigned); template <class X> void add(const X&);
  template <class... A> std::vector<std::shared_ptr<M const>> getInterval(const A&...) const; template <class T> std::shared_ptr<M const> getElemBeforeTime(const T&) const; template <class T> std::shared_ptr<M const> getElemAfterTime(const T&) const;
  rclcpp::Time getLatestTime() const; rclcpp::Time getOldestTime() const; };
template <class M> class PassThrough : public SimpleFilter<M> { public: PassThrough(); template <class F> PassThrough(F&); template <class F> void connectInput(F&); template <class X> void add(const X&); };
template <class M> class TimeSequencer : public SimpleFilter<M> { public: template <class... A> TimeSequencer(A&&...); template <class F> void connectInput(F&); template <class X> void add(const X&); };
template <class M> class Chain : public SimpleFilter<M> { public: Chain(); template <class F> Chain(F&); template <class F> size_t addFilter(F*); template <class F> size_t addFilter(const std::shared_ptr<F>&); };
}
