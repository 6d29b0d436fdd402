// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
// What generated message headers are made of.
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>
#define ROSARCH_POINTERS(T) typedef std::shared_ptr<T> SharedPtr; typedef std::shared_ptr<T const> ConstSharedPtr; typedef std::weak_ptr<T> WeakPtr; \
  typedef std::weak_ptr<T const> ConstWeakPtr; typedef std::unique_ptr<T> UniquePtr; typedef std::unique_ptr<T const> ConstUniquePtr; typedef T* RawPtr; \
  typedef const T* ConstRawPtr;
#define ROSARCH_MESSAGE(T) typedef T Type; ROSARCH_POINTERS(T) T(); T(const T&); T& operator=(const T&); bool operator==(const T&) const; \
  bool operator!=(const T&) const;
namespace rosarch { struct service_event_ { ROSARCH_POINTERS(service_event_) }; }
#define ROSARCH_SERVICE(T) typedef rosarch::service_event_ Event; ROSARCH_POINTERS(T)
#define ROSARCH_ACTION(T) struct Impl { struct SendGoalService {}; struct GetResultService {}; struct FeedbackMessage {}; struct CancelGoalService {}; \
  struct GoalStatusMessage {}; }; ROSARCH_POINTERS(T)
