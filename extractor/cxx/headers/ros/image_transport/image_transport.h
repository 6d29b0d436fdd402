// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/CameraInfo.h>
namespace image_transport {
class TransportHints { public: TransportHints(const std::string& = "raw", const ros::TransportHints& = ros::TransportHints(),
  const ros::NodeHandle& = ros::NodeHandle("~"), const std::string& = "image_transport"); const std::string& getTransport() const; };
class SingleSubscriberPublisher { public: template <class M> void publish(const M&) const; std::string getTopic() const;
  std::string getSubscriberName() const; };
typedef boost::function<void(const SingleSubscriberPublisher&)> SubscriberStatusCallback;
class Publisher { public: Publisher(); uint32_t getNumSubscribers() const; std::string getTopic() const;
  template <class M> void publish(const M& message) const; void shutdown(); operator void*() const; bool operator<(const Publisher&) const;
  };
class CameraPublisher { public: CameraPublisher(); uint32_t getNumSubscribers() const; std::string getTopic() const;
  std::string getInfoTopic() const; template <class I, class C, class... A> void publish(const I& image, const C& info, const A&...) const;
  void shutdown(); operator void*() const; };
class Subscriber { public: Subscriber(); std::string getTopic() const; uint32_t getNumPublishers() const; std::string getTransport() const;
  void shutdown(); operator void*() const; };
class CameraSubscriber { public: CameraSubscriber(); std::string getTopic() const; std::string getInfoTopic() const;
  uint32_t getNumPublishers() const; std::string getTransport() const; void shutdown(); operator void*() const; };
class ImageTransport {
public:
  typedef boost::function<void(const sensor_msgs::ImageConstPtr&)> Callback; typedef sensor_msgs::ImageConstPtr ImageConstPtr;
    typedef sensor_msgs::CameraInfoConstPtr CameraInfoConstPtr;
  explicit ImageTransport(const ros::NodeHandle&); ~ImageTransport();
  template <class Topic, class Queue, class... A> Publisher advertise(const Topic& topic, const Queue& queue_size, const A&...);
  template <class Topic, class Queue, class F, class... A> Subscriber subscribe(const Topic& topic, const Queue& queue_size,
    const F& callback, const A&...);
  template <class T> Subscriber subscribe(const std::string& topic, uint32_t queue_size,
    void (T::*callback)(const sensor_msgs::ImageConstPtr&), const rosarch::any& object, const TransportHints& = TransportHints());
  template <class Topic, class Queue, class... A> CameraPublisher advertiseCamera(const Topic& topic, const Queue& queue_size, const A&...);
  template <class Topic, class Queue, class F, class... A> CameraSubscriber subscribeCamera(const Topic& topic, const Queue& queue_size,
    const F& callback, const A&...);
  std::vector<std::string> getDeclaredTransports() const; std::vector<std::string> getLoadableTransports() const;
};
std::string getCameraInfoTopic(const std::string&);
}
