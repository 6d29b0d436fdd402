// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/ros.h>
namespace nodelet {
class UninitializedException : public std::runtime_error { public: UninitializedException(); };
class Nodelet {
public:
  Nodelet(); virtual ~Nodelet();
  void init(const std::string&, const ros::M_string&, const std::vector<std::string>&, ros::CallbackQueueInterface* = 0,
    ros::CallbackQueueInterface* = 0);
protected:
  const std::string& getName() const; std::string getSuffixedName(const std::string&) const;
    const std::vector<std::string>& getMyArgv() const; const ros::M_string& getRemappingArgs() const;
  ros::NodeHandle& getNodeHandle() const; ros::NodeHandle& getPrivateNodeHandle() const; ros::NodeHandle& getMTNodeHandle() const;
    ros::NodeHandle& getMTPrivateNodeHandle() const; ros::CallbackQueueInterface& getSTCallbackQueue() const;
    ros::CallbackQueueInterface& getMTCallbackQueue() const;
private:
  virtual void onInit() = 0;
};
}
// The log macros of nodelets; their form is that of the ROS_ macros.
#define NODELET_DEBUG(...) (::ros::console::print(::ros::console::levels::Debug, __VA_ARGS__))
#define NODELET_DEBUG_STREAM(args) (::ros::console::stream(::ros::console::levels::Debug) << args)
#define NODELET_DEBUG_ONCE(...) (::ros::console::print(::ros::console::levels::Debug, __VA_ARGS__))
#define NODELET_DEBUG_STREAM_ONCE(args) (::ros::console::stream(::ros::console::levels::Debug) << args)
#define NODELET_DEBUG_COND(cond, ...) ((void)(cond), ::ros::console::print(::ros::console::levels::Debug, __VA_ARGS__))
#define NODELET_DEBUG_STREAM_COND(cond, args) ((void)(cond), ::ros::console::stream(::ros::console::levels::Debug) << args)
#define NODELET_DEBUG_THROTTLE(period, ...) ((void)(period), ::ros::console::print(::ros::console::levels::Debug, __VA_ARGS__))
#define NODELET_DEBUG_STREAM_THROTTLE(period, args) ((void)(period), ::ros::console::stream(::ros::console::levels::Debug) << args)
#define NODELET_DEBUG_FILTER(filter, ...) ((void)(filter), ::ros::console::print(::ros::console::levels::Debug, __VA_ARGS__))
#define NODELET_DEBUG_STREAM_FILTER(filter, args) ((void)(filter), ::ros::console::stream(::ros::console::levels::Debug) << args)
#define NODELET_INFO(...) (::ros::console::print(::ros::console::levels::Info, __VA_ARGS__))
#define NODELET_INFO_STREAM(args) (::ros::console::stream(::ros::console::levels::Info) << args)
#define NODELET_INFO_ONCE(...) (::ros::console::print(::ros::console::levels::Info, __VA_ARGS__))
#define NODELET_INFO_STREAM_ONCE(args) (::ros::console::stream(::ros::console::levels::Info) << args)
#define NODELET_INFO_COND(cond, ...) ((void)(cond), ::ros::console::print(::ros::console::levels::Info, __VA_ARGS__))
#define NODELET_INFO_STREAM_COND(cond, args) ((void)(cond), ::ros::console::stream(::ros::console::levels::Info) << args)
#define NODELET_INFO_THROTTLE(period, ...) ((void)(period), ::ros::console::print(::ros::console::levels::Info, __VA_ARGS__))
#define NODELET_INFO_STREAM_THROTTLE(period, args) ((void)(period), ::ros::console::stream(::ros::console::levels::Info) << args)
#define NODELET_INFO_FILTER(filter, ...) ((void)(filter), ::ros::console::print(::ros::console::levels::Info, __VA_ARGS__))
#define NODELET_INFO_STREAM_FILTER(filter, args) ((void)(filter), ::ros::console::stream(::ros::console::levels::Info) << args)
#define NODELET_WARN(...) (::ros::console::print(::ros::console::levels::Warn, __VA_ARGS__))
#define NODELET_WARN_STREAM(args) (::ros::console::stream(::ros::console::levels::Warn) << args)
#define NODELET_WARN_ONCE(...) (::ros::console::print(::ros::console::levels::Warn, __VA_ARGS__))
#define NODELET_WARN_STREAM_ONCE(args) (::ros::console::stream(::ros::console::levels::Warn) << args)
#define NODELET_WARN_COND(cond, ...) ((void)(cond), ::ros::console::print(::ros::console::levels::Warn, __VA_ARGS__))
#define NODELET_WARN_STREAM_COND(cond, args) ((void)(cond), ::ros::console::stream(::ros::console::levels::Warn) << args)
#define NODELET_WARN_THROTTLE(period, ...) ((void)(period), ::ros::console::print(::ros::console::levels::Warn, __VA_ARGS__))
#define NODELET_WARN_STREAM_THROTTLE(period, args) ((void)(period), ::ros::console::stream(::ros::console::levels::Warn) << args)
#define NODELET_WARN_FILTER(filter, ...) ((void)(filter), ::ros::console::print(::ros::console::levels::Warn, __VA_ARGS__))
#define NODELET_WARN_STREAM_FILTER(filter, args) ((void)(filter), ::ros::console::stream(::ros::console::levels::Warn) << args)
#define NODELET_ERROR(...) (::ros::console::print(::ros::console::levels::Error, __VA_ARGS__))
#define NODELET_ERROR_STREAM(args) (::ros::console::stream(::ros::console::levels::Error) << args)
#define NODELET_ERROR_ONCE(...) (::ros::console::print(::ros::console::levels::Error, __VA_ARGS__))
#define NODELET_ERROR_STREAM_ONCE(args) (::ros::console::stream(::ros::console::levels::Error) << args)
#define NODELET_ERROR_COND(cond, ...) ((void)(cond), ::ros::console::print(::ros::console::levels::Error, __VA_ARGS__))
#define NODELET_ERROR_STREAM_COND(cond, args) ((void)(cond), ::ros::console::stream(::ros::console::levels::Error) << args)
#define NODELET_ERROR_THROTTLE(period, ...) ((void)(period), ::ros::console::print(::ros::console::levels::Error, __VA_ARGS__))
#define NODELET_ERROR_STREAM_THROTTLE(period, args) ((void)(period), ::ros::console::stream(::ros::console::levels::Error) << args)
#define NODELET_ERROR_FILTER(filter, ...) ((void)(filter), ::ros::console::print(::ros::console::levels::Error, __VA_ARGS__))
#define NODELET_ERROR_STREAM_FILTER(filter, args) ((void)(filter), ::ros::console::stream(::ros::console::levels::Error) << args)
#define NODELET_FATAL(...) (::ros::console::print(::ros::console::levels::Fatal, __VA_ARGS__))
#define NODELET_FATAL_STREAM(args) (::ros::console::stream(::ros::console::levels::Fatal) << args)
#define NODELET_FATAL_ONCE(...) (::ros::console::print(::ros::console::levels::Fatal, __VA_ARGS__))
#define NODELET_FATAL_STREAM_ONCE(args) (::ros::console::stream(::ros::console::levels::Fatal) << args)
#define NODELET_FATAL_COND(cond, ...) ((void)(cond), ::ros::console::print(::ros::console::levels::Fatal, __VA_ARGS__))
#define NODELET_FATAL_STREAM_COND(cond, args) ((void)(cond), ::ros::console::stream(::ros::console::levels::Fatal) << args)
#define NODELET_FATAL_THROTTLE(period, ...) ((void)(period), ::ros::console::print(::ros::console::levels::Fatal, __VA_ARGS__))
#define NODELET_FATAL_STREAM_THROTTLE(period, args) ((void)(period), ::ros::console::stream(::ros::console::levels::Fatal) << args)
#define NODELET_FATAL_FILTER(filter, ...) ((void)(filter), ::ros::console::print(::ros::console::levels::Fatal, __VA_ARGS__))
#define NODELET_FATAL_STREAM_FILTER(filter, args) ((void)(filter), ::ros::console::stream(::ros::console::levels::Fatal) << args)
