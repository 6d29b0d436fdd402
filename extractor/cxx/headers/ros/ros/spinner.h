// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/callback_queue.h>
namespace ros {
class Spinner { public: virtual ~Spinner(); virtual void spin(CallbackQueue* = 0) = 0; };
class SingleThreadedSpinner : public Spinner { public: void spin(CallbackQueue* = 0) override; };
class MultiThreadedSpinner : public Spinner { public: MultiThreadedSpinner(uint32_t threads = 0); void spin(CallbackQueue* = 0) override; };
class AsyncSpinner {
public:
  explicit AsyncSpinner(uint32_t threads);
  AsyncSpinner(uint32_t threads, CallbackQueue*);
  bool canStart(); void start(); void stop();
};
}
