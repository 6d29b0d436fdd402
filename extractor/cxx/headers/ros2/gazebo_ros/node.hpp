// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <string>
#include <rclcpp/rclcpp.hpp>
namespace gazebo_ros {
class QoS { public: rclcpp::QoS get_publisher_qos(const std::string& topic, rclcpp::QoS default_qos = rclcpp::QoS(10)) const; rclcpp::QoS get_subscription_qos(const std::string& topic, rclcpp::QoS default_qos = rclcpp::QoS(10)) const; };
class Node : public rclcpp::Node { public: typedef std::shared_ptr<Node> SharedPtr; virtual ~Node();
  template <class... A> static SharedPtr Get(const A&... sdf_name);
  template <class... A> static SharedPtr CreateWithArgs(A&&...);
  const QoS& get_qos() const; };
}
