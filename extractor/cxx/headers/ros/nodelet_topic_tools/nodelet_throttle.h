// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <nodelet/nodelet.h>
namespace nodelet_topic_tools { template <class M> class NodeletThrottle : public nodelet::Nodelet { void onInit() override; };
  template <class M> class NodeletMUX : public nodelet::Nodelet { void onInit() override; };
  class NodeletLazy : public nodelet::Nodelet { protected: void onInit() override; virtual void onInitPostProcess();
  virtual void subscribe() = 0; virtual void unsubscribe() = 0;
  template <class M> ros::Publisher advertise(ros::NodeHandle&, std::string topic, int queue, bool latch = false);
  boost::shared_ptr<ros::NodeHandle> nh_, pnh_; bool verbose_connection_; bool lazy_; }; }
