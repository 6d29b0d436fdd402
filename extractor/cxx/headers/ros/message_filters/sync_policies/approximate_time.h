// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <message_filters/synchronizer.h>
namespace message_filters { namespace sync_policies { template <class... M> struct ApproximateTime : rosarch_policy<M...> {
  ApproximateTime(); ApproximateTime(uint32_t queue_size); }; } }
