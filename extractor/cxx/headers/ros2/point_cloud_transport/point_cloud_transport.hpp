// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rclcpp/rclcpp.hpp>
#include <message_filters/subscriber.hpp>
#include <sensor_msgs/msg/point_cloud2.hpp>
namespace point_cloud_transport {
class TransportHints { public: template <class... A> TransportHints(const A&...); std::string getTransport() const; };
class Publisher { public: Publisher(); size_t getNumSubscribers() const; std::string getTopic() const; template <class M> void publish(M&& message) const; void shutdown(); operator void*() const; };
class Subscriber { public: Subscriber(); std::string getTopic() const; size_t getNumPublishers() const; void shutdown(); operator void*() const; };
template <class N, class T, class... A> Publisher create_publisher(const N& node, const T& topic, const A&...);
template <class N, class T, class F, class... A> Subscriber create_subscription(const N& node, const T& topic, const F& callback, const A&...);
class PointCloudTransport { public: template <class N> explicit PointCloudTransport(const N& node); template <class T, class Q, class... A> Publisher advertise(const T& topic, const Q& queue, const A&...);
  template <class T, class Q, class F, class... A> Subscriber subscribe(const T& topic, const Q& queue, const F& callback, const A&...);
  // (topic, qos, callback, {}, &hints)
  template <class T, class Q, class F> Subscriber subscribe(const T& topic, const Q& queue, const F& callback, const std::shared_ptr<void>& tracked, const TransportHints* hints = nullptr, bool latest = false); };
class SubscriberFilter : public message_filters::SimpleFilter<sensor_msgs::msg::PointCloud2> { public: SubscriberFilter(); template <class N, class T, class... A> SubscriberFilter(const N& node, const T& topic, const A&... transport_qos);
  template <class N, class T, class... A> void subscribe(const N& node, const T& topic, const A&... transport_qos); void unsubscribe(); };
}
