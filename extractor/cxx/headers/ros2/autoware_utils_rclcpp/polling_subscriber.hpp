// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rclcpp/rclcpp.hpp>
namespace autoware_utils_rclcpp {
rclcpp::SensorDataQoS single_depth_sensor_qos();
namespace polling_policy { template <class M> struct Latest {}; template <class M> struct Newest {}; template <class M> struct All {}; }
template <class M, template <class> class Policy> struct rosarch_taken { typedef typename M::ConstSharedPtr type; };
template <class M> struct rosarch_taken<M, polling_policy::All> { typedef std::vector<typename M::ConstSharedPtr> type; };
template <class M, template <class> class Policy = polling_policy::Latest> class InterProcessPollingSubscriber { public:
  typedef std::shared_ptr<InterProcessPollingSubscriber<M, Policy>> SharedPtr; typedef std::unique_ptr<InterProcessPollingSubscriber<M, Policy>> UniquePtr;
  template <class N, class T, class... A> InterProcessPollingSubscriber(N* node, const T& topic, const A&... qos);
  template <class N, class T, class... A> static SharedPtr create_subscription(N* node, const T& topic, const A&... qos);
  typename rosarch_taken<M, Policy>::type take_data(); typename rclcpp::Subscription<M>::SharedPtr subscriber(); };
}
