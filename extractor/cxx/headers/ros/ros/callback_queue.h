// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <boost/shared_ptr.hpp>
#include <ros/duration.h>
namespace ros {
class CallbackInterface { public: enum CallResult { Success, TryAgain, Invalid }; virtual ~CallbackInterface();
  virtual CallResult call() = 0; virtual bool ready(); };
typedef boost::shared_ptr<CallbackInterface> CallbackInterfacePtr;
class CallbackQueueInterface { public: virtual ~CallbackQueueInterface();
  virtual void addCallback(const CallbackInterfacePtr&, uint64_t = 0) = 0; virtual void removeByID(uint64_t) = 0; };
class CallbackQueue : public CallbackQueueInterface {
public:
  enum CallOneResult { Called, TryAgain, Disabled, Empty };
  CallbackQueue(bool enabled = true);
  void addCallback(const CallbackInterfacePtr&, uint64_t = 0) override;
  void removeByID(uint64_t) override;
  CallOneResult callOne();
  CallOneResult callOne(WallDuration);
  void callAvailable();
  void callAvailable(WallDuration);
  bool empty(); bool isEmpty(); void clear(); void enable(); void disable(); bool isEnabled();
};
typedef boost::shared_ptr<CallbackQueue> CallbackQueuePtr;
}
