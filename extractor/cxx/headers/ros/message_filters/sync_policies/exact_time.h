// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <message_filters/synchronizer.h>
namespace message_filters { namespace sync_policies { template <class... M> struct ExactTime : rosarch_policy<M...> { ExactTime();
  ExactTime(uint32_t queue_size); template <class... A> Connection registerDropCallback(const A&...); }; } }
