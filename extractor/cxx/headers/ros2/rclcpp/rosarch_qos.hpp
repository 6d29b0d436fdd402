// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rclcpp/rosarch_time.hpp>
#include <rmw/qos_profiles.h>
namespace rclcpp {
enum class HistoryPolicy { KeepLast, KeepAll, SystemDefault, Unknown };
enum class ReliabilityPolicy { BestEffort, Reliable, SystemDefault, BestAvailable, Unknown };
enum class DurabilityPolicy { Volatile, TransientLocal, SystemDefault, BestAvailable, Unknown };
enum class LivelinessPolicy { Automatic, ManualByTopic, SystemDefault, BestAvailable, Unknown };
enum class QoSCompatibility { Ok, Warning, Error };
struct QoSInitialization { QoSInitialization(rmw_qos_history_policy_t, size_t); static QoSInitialization from_rmw(const rmw_qos_profile_t&); size_t depth; };
struct KeepAll : public QoSInitialization { KeepAll(); };
struct KeepLast : public QoSInitialization { explicit KeepLast(size_t depth, bool = true); };
class QoS {
public:
  explicit QoS(const QoSInitialization& initialization, const rmw_qos_profile_t& profile = rmw_qos_profile_default);
  QoS(size_t history_depth);
  QoS(const QoS&);
  QoS& operator=(const QoS&);
  rmw_qos_profile_t& get_rmw_qos_profile(); const rmw_qos_profile_t& get_rmw_qos_profile() const;
  QoS& history(HistoryPolicy); QoS& history(rmw_qos_history_policy_t); QoS& keep_last(size_t depth); QoS& keep_all();
  QoS& reliability(ReliabilityPolicy); QoS& reliability(rmw_qos_reliability_policy_t); QoS& reliable(); QoS& best_effort(); QoS& reliability_best_available();
  QoS& durability(DurabilityPolicy); QoS& durability(rmw_qos_durability_policy_t); QoS& durability_volatile(); QoS& transient_local();
  QoS& durability_best_available();
  template <class T> QoS& deadline(const T&); template <class T> QoS& lifespan(const T&); template <class T> QoS& liveliness_lease_duration(const T&);
  QoS& liveliness(LivelinessPolicy); QoS& liveliness(rmw_qos_liveliness_policy_t); QoS& avoid_ros_namespace_conventions(bool);
  HistoryPolicy history() const; size_t depth() const; ReliabilityPolicy reliability() const; DurabilityPolicy durability() const;
  Duration deadline() const; Duration lifespan() const; LivelinessPolicy liveliness() const; Duration liveliness_lease_duration() const;
};
bool operator==(const QoS&, const QoS&); bool operator!=(const QoS&, const QoS&);
class SensorDataQoS : public QoS { public: explicit SensorDataQoS(const QoSInitialization& = KeepLast(5)); };
class ParametersQoS : public QoS { public: explicit ParametersQoS(const QoSInitialization& = KeepLast(5)); };
class ServicesQoS : public QoS { public: explicit ServicesQoS(const QoSInitialization& = KeepLast(5)); };
class ParameterEventsQoS : public QoS { public: explicit ParameterEventsQoS(const QoSInitialization& = KeepLast(5)); };
class ClockQoS : public QoS { public: explicit ClockQoS(const QoSInitialization& = KeepLast(1)); };
class RosoutQoS : public QoS { public: explicit RosoutQoS(const QoSInitialization& = KeepLast(5)); };
class SystemDefaultsQoS : public QoS { public: explicit SystemDefaultsQoS(const QoSInitialization& = KeepLast(5)); };
class BestAvailableQoS : public QoS { public: explicit BestAvailableQoS(const QoSInitialization& = KeepLast(5)); };
struct UnsupportedEventTypeException : public std::runtime_error { using std::runtime_error::runtime_error; };
struct QosCallbackResult { bool successful; std::string reason; };
enum class QosPolicyKind { AvoidRosNamespaceConventions, Deadline, Depth, Durability, History, Lifespan, Liveliness, LivelinessLeaseDuration, Reliability, Invalid };
struct QosOverridingOptions { QosOverridingOptions();
  QosOverridingOptions(std::initializer_list<QosPolicyKind>, std::function<QosCallbackResult(const QoS&)> = nullptr, std::string id = {}); template <class... A> static QosOverridingOptions with_default_policies(const A&...); };
template <class... A> QoSCompatibility qos_check_compatible(const A&...);
typedef rmw_matched_status_t MatchedInfo;
struct QOSDeadlineRequestedInfo { int total_count, total_count_change; }; struct QOSDeadlineOfferedInfo { int total_count, total_count_change; };
struct QOSLivelinessChangedInfo { int alive_count, not_alive_count, alive_count_change, not_alive_count_change; };
struct QOSLivelinessLostInfo { int total_count, total_count_change; }; struct QOSMessageLostInfo { size_t total_count, total_count_change; };
struct QOSRequestedIncompatibleQoSInfo { int total_count, total_count_change; int last_policy_kind; };
struct QOSOfferedIncompatibleQoSInfo { int total_count, total_count_change; int last_policy_kind; };
struct IncompatibleTypeInfo { int total_count, total_count_change; };
typedef std::function<void(MatchedInfo&)> PublisherMatchedCallbackType, SubscriptionMatchedCallbackType;
typedef std::function<void(QOSDeadlineRequestedInfo&)> QOSDeadlineRequestedCallbackType; typedef std::function<void(QOSDeadlineOfferedInfo&)> QOSDeadlineOfferedCallbackType;
typedef std::function<void(QOSLivelinessChangedInfo&)> QOSLivelinessChangedCallbackType; typedef std::function<void(QOSLivelinessLostInfo&)> QOSLivelinessLostCallbackType;
typedef std::function<void(QOSMessageLostInfo&)> QOSMessageLostCallbackType; typedef std::function<void(IncompatibleTypeInfo&)> IncompatibleTypeCallbackType;
typedef std::function<void(QOSRequestedIncompatibleQoSInfo&)> QOSRequestedIncompatibleQoSCallbackType;
typedef std::function<void(QOSOfferedIncompatibleQoSInfo&)> QOSOfferedIncompatibleQoSCallbackType;
struct PublisherEventCallbacks { rosarch::any deadline_callback, liveliness_callback, incompatible_qos_callback, incompatible_type_callback, matched_callback; };
struct SubscriptionEventCallbacks { rosarch::any deadline_callback, liveliness_callback, incompatible_qos_callback, incompatible_type_callback, message_lost_callback, matched_callback; };
}
