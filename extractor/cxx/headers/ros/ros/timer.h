// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/time.h>
#include <boost/function.hpp>
#include <boost/shared_ptr.hpp>
namespace ros {
#define ROSARCH_TIMER(TimerName, EventName, T, D) \
  struct EventName { \
    T last_expected, last_real, last_expired, current_expected, current_real, current_expired; \
    struct { WallDuration last_duration; } profile; \
  }; \
  typedef boost::function<void(const EventName&)> TimerName##Callback; \
  class TimerName { \
  public: \
    TimerName(); \
    TimerName(const TimerName&); \
    ~TimerName(); \
    TimerName& operator=(const TimerName&); \
    void start(); \
    void stop(); \
    bool hasPending(); \
    bool hasStarted() const; \
    bool isValid(); \
    void setPeriod(const D& period, bool reset = true); \
    operator void*(); \
    bool operator<(const TimerName&); \
    bool operator==(const TimerName&); \
    bool operator!=(const TimerName&); \
  };
ROSARCH_TIMER(Timer, TimerEvent, Time, Duration)
ROSARCH_TIMER(WallTimer, WallTimerEvent, WallTime, WallDuration)
ROSARCH_TIMER(SteadyTimer, SteadyTimerEvent, SteadyTime, WallDuration)
#undef ROSARCH_TIMER
class CallbackQueueInterface;
// Options are filled field by field; any arguments construct them.
struct TimerOptions { TimerOptions(); template <class... A> TimerOptions(const A&...); Duration period; TimerCallback callback;
  CallbackQueueInterface* callback_queue; boost::shared_ptr<const void> tracked_object; bool oneshot; bool autostart; };
struct WallTimerOptions { WallTimerOptions(); template <class... A> WallTimerOptions(const A&...); WallDuration period;
  WallTimerCallback callback; CallbackQueueInterface* callback_queue; boost::shared_ptr<const void> tracked_object; bool oneshot;
  bool autostart; };
struct SteadyTimerOptions { SteadyTimerOptions(); template <class... A> SteadyTimerOptions(const A&...); WallDuration period;
  SteadyTimerCallback callback; CallbackQueueInterface* callback_queue; boost::shared_ptr<const void> tracked_object; bool oneshot;
  bool autostart; };
}
