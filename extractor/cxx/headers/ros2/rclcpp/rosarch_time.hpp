// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>
#include <future>
#include <rosarch/any.h>
#include <rcutils/logging_macros.h>
#include <builtin_interfaces/msg/time.hpp>
#include <builtin_interfaces/msg/duration.hpp>
#define RCLCPP_POINTERS(T) typedef std::shared_ptr<T> SharedPtr; typedef std::shared_ptr<const T> ConstSharedPtr; typedef std::weak_ptr<T> WeakPtr; \
  typedef std::weak_ptr<const T> ConstWeakPtr; typedef std::unique_ptr<T> UniquePtr; typedef std::unique_ptr<const T> ConstUniquePtr;
#define RCLCPP_SHARED_PTR_DEFINITIONS(...) typedef std::shared_ptr<__VA_ARGS__> SharedPtr; typedef std::shared_ptr<const __VA_ARGS__> ConstSharedPtr; \
  template <class... A> static std::shared_ptr<__VA_ARGS__> make_shared(A&&...);
#define RCLCPP_WEAK_PTR_DEFINITIONS(...) typedef std::weak_ptr<__VA_ARGS__> WeakPtr; typedef std::weak_ptr<const __VA_ARGS__> ConstWeakPtr;
#define RCLCPP_UNIQUE_PTR_DEFINITIONS(...) typedef std::unique_ptr<__VA_ARGS__> UniquePtr; \
  template <class... A> static std::unique_ptr<__VA_ARGS__> make_unique(A&&...);
#define RCLCPP_SMART_PTR_DEFINITIONS(...) RCLCPP_SHARED_PTR_DEFINITIONS(__VA_ARGS__) RCLCPP_WEAK_PTR_DEFINITIONS(__VA_ARGS__) \
  RCLCPP_UNIQUE_PTR_DEFINITIONS(__VA_ARGS__)
#define RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(...) RCLCPP_SMART_PTR_DEFINITIONS(__VA_ARGS__)
#define RCLCPP_SMART_PTR_ALIASES_ONLY(...) typedef std::shared_ptr<__VA_ARGS__> SharedPtr; typedef std::weak_ptr<__VA_ARGS__> WeakPtr;
#define RCLCPP_DISABLE_COPY(...) __VA_ARGS__(const __VA_ARGS__&) = delete; __VA_ARGS__& operator=(const __VA_ARGS__&) = delete;
#define RCLCPP_PUBLIC
#define RCLCPP_LOCAL
#define RCLCPP_PUBLIC_TYPE
// versions: as new as the API below
#define RCLCPP_VERSION_MAJOR 28
#define RCLCPP_VERSION_MINOR 3
#define RCLCPP_VERSION_PATCH 3
#define RCLCPP_VERSION_GTE(major, minor, patch) (major < 28 || (major == 28 && minor <= 3))
typedef enum rcl_clock_type_e { RCL_CLOCK_UNINITIALIZED, RCL_ROS_TIME, RCL_SYSTEM_TIME, RCL_STEADY_TIME } rcl_clock_type_t;
typedef int64_t rcl_time_point_value_t;
typedef int64_t rcl_duration_value_t;
typedef int rcl_ret_t;
#define RCL_RET_OK 0
#define RCL_RET_ERROR 1
#define RCL_RET_TIMEOUT 2
template <class... A> rcl_ret_t rcl_timer_exchange_period(const A&...);
namespace rclcpp {
class Duration;
class Time {
public:
  typedef std::shared_ptr<Time> SharedPtr;
  Time(int32_t seconds, uint32_t nanoseconds, rcl_clock_type_t = RCL_SYSTEM_TIME);
  explicit Time(int64_t nanoseconds = 0, rcl_clock_type_t = RCL_SYSTEM_TIME);
  Time(const Time&);
  ROSARCH_OF_UNKNOWN(Time)
  Time(const builtin_interfaces::msg::Time& time, rcl_clock_type_t = RCL_ROS_TIME);
  operator builtin_interfaces::msg::Time() const;
  Time& operator=(const Time&); Time& operator=(const builtin_interfaces::msg::Time&);
  bool operator==(const Time&) const; bool operator!=(const Time&) const; bool operator<(const Time&) const; bool operator<=(const Time&) const;
  bool operator>(const Time&) const; bool operator>=(const Time&) const;
  Time operator+(const Duration&) const; Duration operator-(const Time&) const; Time operator-(const Duration&) const;
  Time& operator+=(const Duration&); Time& operator-=(const Duration&);
  int64_t nanoseconds() const; double seconds() const; static Time max(rcl_clock_type_t = RCL_SYSTEM_TIME); rcl_clock_type_t get_clock_type() const;
};
class Duration {
public:
  Duration(int32_t seconds, uint32_t nanoseconds);
  template <class Rep, class Period> Duration(const std::chrono::duration<Rep, Period>& duration);
  Duration(const builtin_interfaces::msg::Duration&);
  Duration(const Duration&);
  ROSARCH_OF_UNKNOWN(Duration)
  operator builtin_interfaces::msg::Duration() const;
  Duration& operator=(const Duration&); Duration& operator=(const builtin_interfaces::msg::Duration&);
  bool operator==(const Duration&) const; bool operator!=(const Duration&) const; bool operator<(const Duration&) const; bool operator<=(const Duration&) const;
  bool operator>(const Duration&) const; bool operator>=(const Duration&) const;
  Duration operator+(const Duration&) const; Duration operator-(const Duration&) const; Duration& operator+=(const Duration&);
  Duration& operator-=(const Duration&); template <class N> Duration operator*(N) const; template <class N> Duration& operator*=(N);
  int64_t nanoseconds() const; double seconds() const; static Duration max();
  static Duration from_seconds(double seconds); static Duration from_nanoseconds(int64_t nanoseconds);
  template <class D = std::chrono::nanoseconds> D to_chrono() const;
  static Duration from_rmw_time(...);
};
Time operator+(const Duration&, const Time&); Time operator+(const builtin_interfaces::msg::Time&, const Duration&); Time operator-(const builtin_interfaces::msg::Time&, const Duration&);
builtin_interfaces::msg::Time convert_rcl_time_to_sec_nanos(const rcl_time_point_value_t&);
class PreShutdownCallbackHandle { public: template <class... A> PreShutdownCallbackHandle(const A&...); }; class OnShutdownCallbackHandle { public: template <class... A> OnShutdownCallbackHandle(const A&...); };
class Context { public: RCLCPP_SMART_PTR_DEFINITIONS(Context) Context(); bool is_valid() const; bool shutdown(const std::string&);
  template <class F> PreShutdownCallbackHandle add_pre_shutdown_callback(const F&); template <class F> F on_shutdown(F); template <class F> OnShutdownCallbackHandle add_on_shutdown_callback(const F&);
  bool remove_pre_shutdown_callback(const PreShutdownCallbackHandle&); bool remove_on_shutdown_callback(const OnShutdownCallbackHandle&);
  template <class... A> void init(const A&...); };
class Clock {
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Clock)
  explicit Clock(rcl_clock_type_t = RCL_SYSTEM_TIME);
  Time now() const; bool sleep_until(const Time&); bool sleep_for(const Duration&); bool ros_time_is_active(); rcl_clock_type_t get_clock_type() const;
  bool started(); bool wait_until_started();
  template <class... A> std::shared_ptr<int> create_jump_callback(const A&...);
};
class RateBase { public: RCLCPP_SMART_PTR_DEFINITIONS(RateBase) virtual ~RateBase(); virtual bool sleep(); virtual void reset(); };
class Rate : public RateBase {
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Rate)
  explicit Rate(double rate, Clock::SharedPtr = std::make_shared<Clock>());
  template <class Rep, class Period> explicit Rate(const std::chrono::duration<Rep, Period>& period);
  explicit Rate(const Duration& period, Clock::SharedPtr = std::make_shared<Clock>());
  bool sleep() override; void reset() override; Duration period() const; bool is_steady() const; rcl_clock_type_t get_type() const;
};
class WallRate : public Rate { public: RCLCPP_SMART_PTR_DEFINITIONS(WallRate) explicit WallRate(double rate); explicit WallRate(const Duration& period);
  template <class Rep, class Period> explicit WallRate(const std::chrono::duration<Rep, Period>& period); bool sleep() override; };
class ROSRate : public Rate { public: RCLCPP_SMART_PTR_DEFINITIONS(ROSRate) explicit ROSRate(double rate); explicit ROSRate(const Duration& period); bool sleep() override; };
template <class C = std::chrono::system_clock> class GenericRate : public RateBase { public: RCLCPP_SMART_PTR_DEFINITIONS(GenericRate) explicit GenericRate(double rate);
  template <class D> explicit GenericRate(const D& period); bool sleep() override; void reset() override; std::chrono::nanoseconds period() const; bool is_steady() const; };

class Logger {
public:
  enum class Level { Unset, Debug, Info, Warn, Error, Fatal };
  Logger(); Logger(const Logger&);
  const char* get_name() const; Logger get_child(const std::string&); void set_level(Level); Level get_effective_level() const;
};
Logger get_logger(const std::string& name);
Logger get_node_logger(const void*);
}
