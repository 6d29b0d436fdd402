// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rclcpp_lifecycle/lifecycle_node.hpp>
namespace bond {
class Bond { public: RCLCPP_POINTERS(Bond) template <class... A> Bond(const std::string& topic, const std::string& id, const A&... node_and_callbacks); double getConnectTimeout() const; void setConnectTimeout(double); double getDisconnectTimeout() const;
  void setDisconnectTimeout(double); double getHeartbeatTimeout() const; void setHeartbeatTimeout(double); double getHeartbeatPeriod() const; void setHeartbeatPeriod(double);
  template <class F> void setFormedCallback(const F&); template <class F> void setBrokenCallback(const F&); void start(); bool waitUntilFormed(rclcpp::Duration = rclcpp::Duration(-1, 0)); bool waitUntilBroken(rclcpp::Duration = rclcpp::Duration(-1, 0));
  void breakBond(); bool isBroken(); std::string getTopic() const; std::string getId() const; std::string getInstanceId() const; };
}
