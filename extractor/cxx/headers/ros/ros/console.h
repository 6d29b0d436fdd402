// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <iostream>
#include <sstream>
#include <string>
// Every log macro is one expression: a call of ros::console::print with all arguments, or a chain of << that starts at
// ros::console::stream. Conditions, periods and logger names come first, as `(void)(x)`.
namespace ros { namespace console {
namespace levels { enum Level { Debug, Info, Warn, Error, Fatal, Count }; }
typedef levels::Level Level;
template <class... A> void print(Level, const A&...);
std::ostream& stream(Level);
bool set_logger_level(const std::string&, Level);
void notifyLoggerLevelsChanged();
void initialize(); void shutdown();
class FilterBase { public: virtual bool isEnabled(); };
} }
#define ROSCONSOLE_DEFAULT_NAME "ros"
#define ROSCONSOLE_NAME_PREFIX "ros"
#define ROSCONSOLE_AUTOINIT ((void)0)
#define ROS_LOG(level, name, ...) ((void)(name), ::ros::console::print(level, __VA_ARGS__))
#define ROS_LOG_STREAM(level, name, args) ((void)(name), ::ros::console::stream(level) << args)
#define ROS_LOG_COND(condition, level, name, ...) ((void)(condition), (void)(name), ::ros::console::print(level, __VA_ARGS__))

#define ROS_DEBUG(...) (::ros::console::print(::ros::console::levels::Debug, __VA_ARGS__))
#define ROS_DEBUG_STREAM(args) (::ros::console::stream(::ros::console::levels::Debug) << args)
#define ROS_DEBUG_NAMED(name, ...) ((void)(name), ::ros::console::print(::ros::console::levels::Debug, __VA_ARGS__))
#define ROS_DEBUG_STREAM_NAMED(name, args) ((void)(name), ::ros::console::stream(::ros::console::levels::Debug) << args)
#define ROS_DEBUG_COND(cond, ...) ((void)(cond), ::ros::console::print(::ros::console::levels::Debug, __VA_ARGS__))
#define ROS_DEBUG_STREAM_COND(cond, args) ((void)(cond), ::ros::console::stream(::ros::console::levels::Debug) << args)
#define ROS_DEBUG_COND_NAMED(cond, name, ...) ((void)(cond), (void)(name), ::ros::console::print(::ros::console::levels::Debug, \
  __VA_ARGS__))
#define ROS_DEBUG_STREAM_COND_NAMED(cond, name, args) ((void)(cond), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Debug) << args)
#define ROS_DEBUG_ONCE(...) (::ros::console::print(::ros::console::levels::Debug, __VA_ARGS__))
#define ROS_DEBUG_STREAM_ONCE(args) (::ros::console::stream(::ros::console::levels::Debug) << args)
#define ROS_DEBUG_ONCE_NAMED(name, ...) ((void)(name), ::ros::console::print(::ros::console::levels::Debug, __VA_ARGS__))
#define ROS_DEBUG_STREAM_ONCE_NAMED(name, args) ((void)(name), ::ros::console::stream(::ros::console::levels::Debug) << args)
#define ROS_DEBUG_THROTTLE(period, ...) ((void)(period), ::ros::console::print(::ros::console::levels::Debug, __VA_ARGS__))
#define ROS_DEBUG_STREAM_THROTTLE(period, args) ((void)(period), ::ros::console::stream(::ros::console::levels::Debug) << args)
#define ROS_DEBUG_THROTTLE_NAMED(period, name, ...) ((void)(period), (void)(name), ::ros::console::print(::ros::console::levels::Debug, \
  __VA_ARGS__))
#define ROS_DEBUG_STREAM_THROTTLE_NAMED(period, name, args) ((void)(period), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Debug) << args)
#define ROS_DEBUG_DELAYED_THROTTLE(period, ...) ((void)(period), ::ros::console::print(::ros::console::levels::Debug, __VA_ARGS__))
#define ROS_DEBUG_STREAM_DELAYED_THROTTLE(period, args) ((void)(period), ::ros::console::stream(::ros::console::levels::Debug) << args)
#define ROS_DEBUG_DELAYED_THROTTLE_NAMED(period, name, ...) ((void)(period), (void)(name), \
  ::ros::console::print(::ros::console::levels::Debug, __VA_ARGS__))
#define ROS_DEBUG_STREAM_DELAYED_THROTTLE_NAMED(period, name, args) ((void)(period), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Debug) << args)
#define ROS_DEBUG_FILTER(filter, ...) ((void)(filter), ::ros::console::print(::ros::console::levels::Debug, __VA_ARGS__))
#define ROS_DEBUG_STREAM_FILTER(filter, args) ((void)(filter), ::ros::console::stream(::ros::console::levels::Debug) << args)
#define ROS_DEBUG_FILTER_NAMED(filter, name, ...) ((void)(filter), (void)(name), ::ros::console::print(::ros::console::levels::Debug, \
  __VA_ARGS__))
#define ROS_DEBUG_STREAM_FILTER_NAMED(filter, name, args) ((void)(filter), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Debug) << args)

#define ROS_INFO(...) (::ros::console::print(::ros::console::levels::Info, __VA_ARGS__))
#define ROS_INFO_STREAM(args) (::ros::console::stream(::ros::console::levels::Info) << args)
#define ROS_INFO_NAMED(name, ...) ((void)(name), ::ros::console::print(::ros::console::levels::Info, __VA_ARGS__))
#define ROS_INFO_STREAM_NAMED(name, args) ((void)(name), ::ros::console::stream(::ros::console::levels::Info) << args)
#define ROS_INFO_COND(cond, ...) ((void)(cond), ::ros::console::print(::ros::console::levels::Info, __VA_ARGS__))
#define ROS_INFO_STREAM_COND(cond, args) ((void)(cond), ::ros::console::stream(::ros::console::levels::Info) << args)
#define ROS_INFO_COND_NAMED(cond, name, ...) ((void)(cond), (void)(name), ::ros::console::print(::ros::console::levels::Info, __VA_ARGS__))
#define ROS_INFO_STREAM_COND_NAMED(cond, name, args) ((void)(cond), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Info) << args)
#define ROS_INFO_ONCE(...) (::ros::console::print(::ros::console::levels::Info, __VA_ARGS__))
#define ROS_INFO_STREAM_ONCE(args) (::ros::console::stream(::ros::console::levels::Info) << args)
#define ROS_INFO_ONCE_NAMED(name, ...) ((void)(name), ::ros::console::print(::ros::console::levels::Info, __VA_ARGS__))
#define ROS_INFO_STREAM_ONCE_NAMED(name, args) ((void)(name), ::ros::console::stream(::ros::console::levels::Info) << args)
#define ROS_INFO_THROTTLE(period, ...) ((void)(period), ::ros::console::print(::ros::console::levels::Info, __VA_ARGS__))
#define ROS_INFO_STREAM_THROTTLE(period, args) ((void)(period), ::ros::console::stream(::ros::console::levels::Info) << args)
#define ROS_INFO_THROTTLE_NAMED(period, name, ...) ((void)(period), (void)(name), ::ros::console::print(::ros::console::levels::Info, \
  __VA_ARGS__))
#define ROS_INFO_STREAM_THROTTLE_NAMED(period, name, args) ((void)(period), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Info) << args)
#define ROS_INFO_DELAYED_THROTTLE(period, ...) ((void)(period), ::ros::console::print(::ros::console::levels::Info, __VA_ARGS__))
#define ROS_INFO_STREAM_DELAYED_THROTTLE(period, args) ((void)(period), ::ros::console::stream(::ros::console::levels::Info) << args)
#define ROS_INFO_DELAYED_THROTTLE_NAMED(period, name, ...) ((void)(period), (void)(name), \
  ::ros::console::print(::ros::console::levels::Info, __VA_ARGS__))
#define ROS_INFO_STREAM_DELAYED_THROTTLE_NAMED(period, name, args) ((void)(period), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Info) << args)
#define ROS_INFO_FILTER(filter, ...) ((void)(filter), ::ros::console::print(::ros::console::levels::Info, __VA_ARGS__))
#define ROS_INFO_STREAM_FILTER(filter, args) ((void)(filter), ::ros::console::stream(::ros::console::levels::Info) << args)
#define ROS_INFO_FILTER_NAMED(filter, name, ...) ((void)(filter), (void)(name), ::ros::console::print(::ros::console::levels::Info, \
  __VA_ARGS__))
#define ROS_INFO_STREAM_FILTER_NAMED(filter, name, args) ((void)(filter), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Info) << args)

#define ROS_WARN(...) (::ros::console::print(::ros::console::levels::Warn, __VA_ARGS__))
#define ROS_WARN_STREAM(args) (::ros::console::stream(::ros::console::levels::Warn) << args)
#define ROS_WARN_NAMED(name, ...) ((void)(name), ::ros::console::print(::ros::console::levels::Warn, __VA_ARGS__))
#define ROS_WARN_STREAM_NAMED(name, args) ((void)(name), ::ros::console::stream(::ros::console::levels::Warn) << args)
#define ROS_WARN_COND(cond, ...) ((void)(cond), ::ros::console::print(::ros::console::levels::Warn, __VA_ARGS__))
#define ROS_WARN_STREAM_COND(cond, args) ((void)(cond), ::ros::console::stream(::ros::console::levels::Warn) << args)
#define ROS_WARN_COND_NAMED(cond, name, ...) ((void)(cond), (void)(name), ::ros::console::print(::ros::console::levels::Warn, __VA_ARGS__))
#define ROS_WARN_STREAM_COND_NAMED(cond, name, args) ((void)(cond), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Warn) << args)
#define ROS_WARN_ONCE(...) (::ros::console::print(::ros::console::levels::Warn, __VA_ARGS__))
#define ROS_WARN_STREAM_ONCE(args) (::ros::console::stream(::ros::console::levels::Warn) << args)
#define ROS_WARN_ONCE_NAMED(name, ...) ((void)(name), ::ros::console::print(::ros::console::levels::Warn, __VA_ARGS__))
#define ROS_WARN_STREAM_ONCE_NAMED(name, args) ((void)(name), ::ros::console::stream(::ros::console::levels::Warn) << args)
#define ROS_WARN_THROTTLE(period, ...) ((void)(period), ::ros::console::print(::ros::console::levels::Warn, __VA_ARGS__))
#define ROS_WARN_STREAM_THROTTLE(period, args) ((void)(period), ::ros::console::stream(::ros::console::levels::Warn) << args)
#define ROS_WARN_THROTTLE_NAMED(period, name, ...) ((void)(period), (void)(name), ::ros::console::print(::ros::console::levels::Warn, \
  __VA_ARGS__))
#define ROS_WARN_STREAM_THROTTLE_NAMED(period, name, args) ((void)(period), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Warn) << args)
#define ROS_WARN_DELAYED_THROTTLE(period, ...) ((void)(period), ::ros::console::print(::ros::console::levels::Warn, __VA_ARGS__))
#define ROS_WARN_STREAM_DELAYED_THROTTLE(period, args) ((void)(period), ::ros::console::stream(::ros::console::levels::Warn) << args)
#define ROS_WARN_DELAYED_THROTTLE_NAMED(period, name, ...) ((void)(period), (void)(name), \
  ::ros::console::print(::ros::console::levels::Warn, __VA_ARGS__))
#define ROS_WARN_STREAM_DELAYED_THROTTLE_NAMED(period, name, args) ((void)(period), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Warn) << args)
#define ROS_WARN_FILTER(filter, ...) ((void)(filter), ::ros::console::print(::ros::console::levels::Warn, __VA_ARGS__))
#define ROS_WARN_STREAM_FILTER(filter, args) ((void)(filter), ::ros::console::stream(::ros::console::levels::Warn) << args)
#define ROS_WARN_FILTER_NAMED(filter, name, ...) ((void)(filter), (void)(name), ::ros::console::print(::ros::console::levels::Warn, \
  __VA_ARGS__))
#define ROS_WARN_STREAM_FILTER_NAMED(filter, name, args) ((void)(filter), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Warn) << args)

#define ROS_ERROR(...) (::ros::console::print(::ros::console::levels::Error, __VA_ARGS__))
#define ROS_ERROR_STREAM(args) (::ros::console::stream(::ros::console::levels::Error) << args)
#define ROS_ERROR_NAMED(name, ...) ((void)(name), ::ros::console::print(::ros::console::levels::Error, __VA_ARGS__))
#define ROS_ERROR_STREAM_NAMED(name, args) ((void)(name), ::ros::console::stream(::ros::console::levels::Error) << args)
#define ROS_ERROR_COND(cond, ...) ((void)(cond), ::ros::console::print(::ros::console::levels::Error, __VA_ARGS__))
#define ROS_ERROR_STREAM_COND(cond, args) ((void)(cond), ::ros::console::stream(::ros::console::levels::Error) << args)
#define ROS_ERROR_COND_NAMED(cond, name, ...) ((void)(cond), (void)(name), ::ros::console::print(::ros::console::levels::Error, \
  __VA_ARGS__))
#define ROS_ERROR_STREAM_COND_NAMED(cond, name, args) ((void)(cond), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Error) << args)
#define ROS_ERROR_ONCE(...) (::ros::console::print(::ros::console::levels::Error, __VA_ARGS__))
#define ROS_ERROR_STREAM_ONCE(args) (::ros::console::stream(::ros::console::levels::Error) << args)
#define ROS_ERROR_ONCE_NAMED(name, ...) ((void)(name), ::ros::console::print(::ros::console::levels::Error, __VA_ARGS__))
#define ROS_ERROR_STREAM_ONCE_NAMED(name, args) ((void)(name), ::ros::console::stream(::ros::console::levels::Error) << args)
#define ROS_ERROR_THROTTLE(period, ...) ((void)(period), ::ros::console::print(::ros::console::levels::Error, __VA_ARGS__))
#define ROS_ERROR_STREAM_THROTTLE(period, args) ((void)(period), ::ros::console::stream(::ros::console::levels::Error) << args)
#define ROS_ERROR_THROTTLE_NAMED(period, name, ...) ((void)(period), (void)(name), ::ros::console::print(::ros::console::levels::Error, \
  __VA_ARGS__))
#define ROS_ERROR_STREAM_THROTTLE_NAMED(period, name, args) ((void)(period), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Error) << args)
#define ROS_ERROR_DELAYED_THROTTLE(period, ...) ((void)(period), ::ros::console::print(::ros::console::levels::Error, __VA_ARGS__))
#define ROS_ERROR_STREAM_DELAYED_THROTTLE(period, args) ((void)(period), ::ros::console::stream(::ros::console::levels::Error) << args)
#define ROS_ERROR_DELAYED_THROTTLE_NAMED(period, name, ...) ((void)(period), (void)(name), \
  ::ros::console::print(::ros::console::levels::Error, __VA_ARGS__))
#define ROS_ERROR_STREAM_DELAYED_THROTTLE_NAMED(period, name, args) ((void)(period), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Error) << args)
#define ROS_ERROR_FILTER(filter, ...) ((void)(filter), ::ros::console::print(::ros::console::levels::Error, __VA_ARGS__))
#define ROS_ERROR_STREAM_FILTER(filter, args) ((void)(filter), ::ros::console::stream(::ros::console::levels::Error) << args)
#define ROS_ERROR_FILTER_NAMED(filter, name, ...) ((void)(filter), (void)(name), ::ros::console::print(::ros::console::levels::Error, \
  __VA_ARGS__))
#define ROS_ERROR_STREAM_FILTER_NAMED(filter, name, args) ((void)(filter), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Error) << args)

#define ROS_FATAL(...) (::ros::console::print(::ros::console::levels::Fatal, __VA_ARGS__))
#define ROS_FATAL_STREAM(args) (::ros::console::stream(::ros::console::levels::Fatal) << args)
#define ROS_FATAL_NAMED(name, ...) ((void)(name), ::ros::console::print(::ros::console::levels::Fatal, __VA_ARGS__))
#define ROS_FATAL_STREAM_NAMED(name, args) ((void)(name), ::ros::console::stream(::ros::console::levels::Fatal) << args)
#define ROS_FATAL_COND(cond, ...) ((void)(cond), ::ros::console::print(::ros::console::levels::Fatal, __VA_ARGS__))
#define ROS_FATAL_STREAM_COND(cond, args) ((void)(cond), ::ros::console::stream(::ros::console::levels::Fatal) << args)
#define ROS_FATAL_COND_NAMED(cond, name, ...) ((void)(cond), (void)(name), ::ros::console::print(::ros::console::levels::Fatal, \
  __VA_ARGS__))
#define ROS_FATAL_STREAM_COND_NAMED(cond, name, args) ((void)(cond), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Fatal) << args)
#define ROS_FATAL_ONCE(...) (::ros::console::print(::ros::console::levels::Fatal, __VA_ARGS__))
#define ROS_FATAL_STREAM_ONCE(args) (::ros::console::stream(::ros::console::levels::Fatal) << args)
#define ROS_FATAL_ONCE_NAMED(name, ...) ((void)(name), ::ros::console::print(::ros::console::levels::Fatal, __VA_ARGS__))
#define ROS_FATAL_STREAM_ONCE_NAMED(name, args) ((void)(name), ::ros::console::stream(::ros::console::levels::Fatal) << args)
#define ROS_FATAL_THROTTLE(period, ...) ((void)(period), ::ros::console::print(::ros::console::levels::Fatal, __VA_ARGS__))
#define ROS_FATAL_STREAM_THROTTLE(period, args) ((void)(period), ::ros::console::stream(::ros::console::levels::Fatal) << args)
#define ROS_FATAL_THROTTLE_NAMED(period, name, ...) ((void)(period), (void)(name), ::ros::console::print(::ros::console::levels::Fatal, \
  __VA_ARGS__))
#define ROS_FATAL_STREAM_THROTTLE_NAMED(period, name, args) ((void)(period), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Fatal) << args)
#define ROS_FATAL_DELAYED_THROTTLE(period, ...) ((void)(period), ::ros::console::print(::ros::console::levels::Fatal, __VA_ARGS__))
#define ROS_FATAL_STREAM_DELAYED_THROTTLE(period, args) ((void)(period), ::ros::console::stream(::ros::console::levels::Fatal) << args)
#define ROS_FATAL_DELAYED_THROTTLE_NAMED(period, name, ...) ((void)(period), (void)(name), \
  ::ros::console::print(::ros::console::levels::Fatal, __VA_ARGS__))
#define ROS_FATAL_STREAM_DELAYED_THROTTLE_NAMED(period, name, args) ((void)(period), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Fatal) << args)
#define ROS_FATAL_FILTER(filter, ...) ((void)(filter), ::ros::console::print(::ros::console::levels::Fatal, __VA_ARGS__))
#define ROS_FATAL_STREAM_FILTER(filter, args) ((void)(filter), ::ros::console::stream(::ros::console::levels::Fatal) << args)
#define ROS_FATAL_FILTER_NAMED(filter, name, ...) ((void)(filter), (void)(name), ::ros::console::print(::ros::console::levels::Fatal, \
  __VA_ARGS__))
#define ROS_FATAL_STREAM_FILTER_NAMED(filter, name, args) ((void)(filter), (void)(name), \
  ::ros::console::stream(::ros::console::levels::Fatal) << args)
