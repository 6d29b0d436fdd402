// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <message_filters/simple_filter.h>
#include <ros/ros.h>
namespace message_filters {
class SubscriberBase { public: virtual ~SubscriberBase(); virtual void unsubscribe(); virtual void subscribe(); };
typedef boost::shared_ptr<SubscriberBase> SubscriberBasePtr;
template <class M> class Subscriber : public SubscriberBase, public SimpleFilter<M> {
public:
  typedef M MType; typedef ros::MessageEvent<const M> EventType;
  Subscriber();
  // (node handle, topic, queue size[, hints][, callback queue])
  template <class Node, class Topic, class Queue, class... A> Subscriber(const Node&, const Topic& topic, const Queue& queue_size,
    const A&...);
  void subscribe() override;
  template <class Node, class Topic, class Queue, class... A> void subscribe(const Node&, const Topic& topic, const Queue& queue_size,
    const A&...);
  void unsubscribe() override;
  std::string getTopic() const; const ros::Subscriber& getSubscriber() const;
  template <class F> void connectInput(F&); template <class X> void add(const X&);
};
}
