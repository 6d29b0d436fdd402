// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <tf2/LinearMath/Transform.h>
#include <rclcpp/rclcpp.hpp>
#include <geometry_msgs/msg/point_stamped.hpp>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <geometry_msgs/msg/quaternion_stamped.hpp>
#include <geometry_msgs/msg/transform_stamped.hpp>
#include <geometry_msgs/msg/vector3_stamped.hpp>
namespace tf2 {
using namespace std::chrono_literals;
typedef std::chrono::nanoseconds Duration;
typedef std::chrono::time_point<std::chrono::system_clock, Duration> TimePoint;
typedef std::chrono::duration<int, std::nano> IDuration;
const TimePoint TimePointZero = TimePoint();
TimePoint get_now(); Duration durationFromSec(double); TimePoint timeFromSec(double); double durationToSec(const Duration&); double timeToSec(const TimePoint&);
std::string displayTimePoint(const TimePoint&); TimePoint TimePointFromMsg(const builtin_interfaces::msg::Time&);
struct TransformException : public std::runtime_error { TransformException(const std::string); };
struct ConnectivityException : public TransformException { ConnectivityException(const std::string); };
struct LookupException : public TransformException { LookupException(const std::string); };
struct ExtrapolationException : public TransformException { ExtrapolationException(const std::string); };
struct BackwardExtrapolationException : public ExtrapolationException { BackwardExtrapolationException(const std::string); };
struct ForwardExtrapolationException : public ExtrapolationException { ForwardExtrapolationException(const std::string); };
struct NoDataForExtrapolationException : public ExtrapolationException { NoDataForExtrapolationException(const std::string); };
struct InvalidArgumentException : public TransformException { InvalidArgumentException(const std::string); };
struct TimeoutException : public TransformException { TimeoutException(const std::string); };
template <class T> class Stamped : public T { public: TimePoint stamp_; std::string frame_id_; Stamped(); template <class... A> Stamped(const T&, const A&...);
  void setData(const T&); bool operator==(const Stamped&) const; };
template <class T> struct WithCovarianceStamped : public T { TimePoint stamp_; std::string frame_id_; WithCovarianceStamped(); template <class... A> WithCovarianceStamped(const A&...); };
template <class A, class B> void convert(const A&, B&);
template <class A, class B> void fromMsg(const A&, B&);
template <class T> void doTransform(const T& in, T& out, const geometry_msgs::msg::TransformStamped&);
template <class A, class B> void doTransform(const A& in, B& out, const geometry_msgs::msg::TransformStamped&);
template <class T> TimePoint getTimestamp(const T&);
template <class T> std::string getFrameId(const T&);
geometry_msgs::msg::Quaternion toMsg(const Quaternion&); geometry_msgs::msg::Vector3 toMsg(const Vector3&); geometry_msgs::msg::Transform toMsg(const Transform&);
geometry_msgs::msg::TransformStamped toMsg(const Stamped<Transform>&); geometry_msgs::msg::QuaternionStamped toMsg(const Stamped<Quaternion>&);
geometry_msgs::msg::PointStamped toMsg(const Stamped<Vector3>&); template <class A, class B> B& toMsg(const A&, B&);
geometry_msgs::msg::PoseStamped toMsg(const geometry_msgs::msg::PoseStamped&);
builtin_interfaces::msg::Time toMsg(const TimePoint&); builtin_interfaces::msg::Duration toMsg(const Duration&);
template <class T> double getYaw(const T&); template <class T> void getEulerYPR(const T&, double&, double&, double&); template <class T> T getTransformIdentity();
class BufferCoreInterface { public: virtual ~BufferCoreInterface(); };
class BufferCore : public BufferCoreInterface {
public:
  RCLCPP_POINTERS(BufferCore)
  template <class... A> BufferCore(const A&...); virtual ~BufferCore();
  void clear(); bool setTransform(const geometry_msgs::msg::TransformStamped&, const std::string& authority, bool is_static = false);
  // (target, source, time[, timeout]) or (target, target time, source, source time, fixed[, timeout])
  template <class A, class B, class C, class... X> geometry_msgs::msg::TransformStamped lookupTransform(const A&, const B&, const C&, const X&...) const;
  template <class A, class B, class C, class... X> bool canTransform(const A&, const B&, const C&, const X&...) const;
  std::string allFramesAsYAML() const; std::string allFramesAsString() const; std::vector<std::string> getAllFrameNames() const; bool _frameExists(const std::string&) const;
  void setUsingDedicatedThread(bool); bool isUsingDedicatedThread() const; template <class... A> bool _getParent(const A&...) const;
};
}
