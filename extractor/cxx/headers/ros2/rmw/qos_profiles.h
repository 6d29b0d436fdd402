// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstddef>
#include <cstdint>
typedef enum rmw_qos_reliability_policy_e { RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT, RMW_QOS_POLICY_RELIABILITY_RELIABLE,
  RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT, RMW_QOS_POLICY_RELIABILITY_UNKNOWN, RMW_QOS_POLICY_RELIABILITY_BEST_AVAILABLE } rmw_qos_reliability_policy_t;
typedef enum rmw_qos_history_policy_e { RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT, RMW_QOS_POLICY_HISTORY_KEEP_LAST, RMW_QOS_POLICY_HISTORY_KEEP_ALL,
  RMW_QOS_POLICY_HISTORY_UNKNOWN } rmw_qos_history_policy_t;
typedef enum rmw_qos_durability_policy_e { RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT, RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL,
  RMW_QOS_POLICY_DURABILITY_VOLATILE, RMW_QOS_POLICY_DURABILITY_UNKNOWN, RMW_QOS_POLICY_DURABILITY_BEST_AVAILABLE } rmw_qos_durability_policy_t;
typedef enum rmw_qos_liveliness_policy_e { RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT, RMW_QOS_POLICY_LIVELINESS_AUTOMATIC,
  RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_NODE, RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC, RMW_QOS_POLICY_LIVELINESS_UNKNOWN,
  RMW_QOS_POLICY_LIVELINESS_BEST_AVAILABLE } rmw_qos_liveliness_policy_t;
typedef enum rmw_qos_policy_kind_e { RMW_QOS_POLICY_INVALID = 1, RMW_QOS_POLICY_DURABILITY = 2, RMW_QOS_POLICY_DEADLINE = 4, RMW_QOS_POLICY_LIVELINESS = 8,
  RMW_QOS_POLICY_RELIABILITY = 16, RMW_QOS_POLICY_HISTORY = 32, RMW_QOS_POLICY_LIFESPAN = 64, RMW_QOS_POLICY_DEPTH = 128 } rmw_qos_policy_kind_t;
typedef struct rmw_time_s { uint64_t sec; uint64_t nsec; } rmw_time_t;
typedef struct rmw_qos_profile_s { rmw_qos_history_policy_t history; size_t depth; rmw_qos_reliability_policy_t reliability; rmw_qos_durability_policy_t durability;
  rmw_time_t deadline; rmw_time_t lifespan; rmw_qos_liveliness_policy_t liveliness; rmw_time_t liveliness_lease_duration;
  bool avoid_ros_namespace_conventions; } rmw_qos_profile_t;
typedef struct rmw_matched_status_s { size_t total_count, total_count_change, current_count; int current_count_change; } rmw_matched_status_t;
extern const rmw_qos_profile_t rmw_qos_profile_sensor_data, rmw_qos_profile_parameters, rmw_qos_profile_default, rmw_qos_profile_services_default,
  rmw_qos_profile_parameter_events, rmw_qos_profile_rosout_default, rmw_qos_profile_system_default, rmw_qos_profile_best_available,
  rmw_qos_profile_unknown, rcl_action_qos_profile_status_default;
const char* rmw_qos_policy_kind_to_str(rmw_qos_policy_kind_t);
typedef struct rmw_message_info_s { int64_t source_timestamp, received_timestamp; } rmw_message_info_t;
typedef struct rmw_request_id_s { int64_t sequence_number; int8_t writer_guid[16]; } rmw_request_id_t;
