// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <tf2/transform_datatypes.h>
namespace tf2 {
template <class A, class B> void convert(const A&, B&);
template <class A, class B> void fromMsg(const A&, B&);
template <class T> void doTransform(const T& in, T& out, const geometry_msgs::TransformStamped&);
template <class A, class B> void doTransform(const A& in, B& out, const geometry_msgs::TransformStamped&);
template <class T> const ros::Time& getTimestamp(const T&);
template <class T> const std::string& getFrameId(const T&);
geometry_msgs::Quaternion toMsg(const Quaternion&); geometry_msgs::Vector3 toMsg(const Vector3&);
  geometry_msgs::Transform toMsg(const Transform&); geometry_msgs::TransformStamped toMsg(const Stamped<Transform>&);
geometry_msgs::QuaternionStamped toMsg(const Stamped<Quaternion>&); geometry_msgs::PointStamped toMsg(const Stamped<Vector3>&);
template <class A, class B> B& toMsg(const A&, B&);
geometry_msgs::PoseStamped toMsg(const geometry_msgs::PoseStamped&); geometry_msgs::PointStamped toMsg(const geometry_msgs::PointStamped&);
double getYaw(const Quaternion&); template <class T> double getYaw(const T&);
  template <class T> void getEulerYPR(const T&, double&, double&, double&); template <class T> Transform getTransformIdentity();
}
