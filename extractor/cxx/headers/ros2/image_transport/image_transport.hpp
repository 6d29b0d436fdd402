// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rclcpp/rclcpp.hpp>
#include <message_filters/subscriber.hpp>
#include <sensor_msgs/msg/camera_info.hpp>
#include <sensor_msgs/msg/image.hpp>
namespace image_transport {
class TransportHints { public: template <class... A> TransportHints(const A&...); std::string getTransport() const; };
class Publisher { public: Publisher(); size_t getNumSubscribers() const; std::string getTopic() const; template <class M> void publish(M&& message) const; void shutdown(); operator void*() const; };
class CameraPublisher { public: CameraPublisher(); size_t getNumSubscribers() const; std::string getTopic() const; std::string getInfoTopic() const; template <class I, class C, class... A> void publish(const I&, const C&, const A&...) const; void shutdown(); operator void*() const; };
class Subscriber { public: Subscriber(); std::string getTopic() const; size_t getNumPublishers() const; std::string getTransport() const; void shutdown(); operator void*() const; };
class CameraSubscriber { public: CameraSubscriber(); std::string getTopic() const; std::string getInfoTopic() const; size_t getNumPublishers() const; std::string getTransport() const; void shutdown(); operator void*() const; };
// (node, topic[, qos[, options]])
template <class N, class T, class... A> Publisher create_publisher(const N& node, const T& topic, const A&...);
// (node, topic, callback, transport[, qos[, options]])
template <class N, class T, class F, class... A> Subscriber create_subscription(const N& node, const T& topic, const F& callback, const A&...);
template <class N, class T, class... A> CameraPublisher create_camera_publisher(const N& node, const T& topic, const A&...);
template <class N, class T, class F, class... A> CameraSubscriber create_camera_subscription(const N& node, const T& topic, const F& callback, const A&...);
class ImageTransport { public: template <class N> explicit ImageTransport(const N& node);
  template <class T, class Q, class... A> Publisher advertise(const T& topic, const Q& queue, const A&...); template <class T, class Q, class F, class... A> Subscriber subscribe(const T& topic, const Q& queue, const F& callback, const A&...);
  // (topic, queue, callback, {}, &hints)
  template <class T, class Q, class F> Subscriber subscribe(const T& topic, const Q& queue, const F& callback, const std::shared_ptr<void>& tracked, const TransportHints* hints = nullptr);
  template <class T, class Q, class... A> CameraPublisher advertiseCamera(const T& topic, const Q& queue, const A&...); template <class T, class Q, class F, class... A> CameraSubscriber subscribeCamera(const T& topic, const Q& queue, const F& callback, const A&...);
  std::vector<std::string> getDeclaredTransports() const; std::vector<std::string> getLoadableTransports() const; };
class SubscriberFilter : public message_filters::SimpleFilter<sensor_msgs::msg::Image> { public: SubscriberFilter(); template <class N, class T, class... A> SubscriberFilter(const N& node, const T& topic, const A&... transport_qos);
  template <class N, class T, class... A> void subscribe(const N& node, const T& topic, const A&... transport_qos); void unsubscribe(); };
}
