// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <message_filters/sync_policies/exact_time.h>
namespace message_filters { template <class... M> class TimeSynchronizer : public Synchronizer<sync_policies::ExactTime<M...>> { public:
  TimeSynchronizer(uint32_t queue_size); template <class A, class... R> TimeSynchronizer(A& first, R&&...); }; }
