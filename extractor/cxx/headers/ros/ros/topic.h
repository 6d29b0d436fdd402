// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/node_handle.h>
namespace ros { namespace topic {
// (topic[, node handle][, timeout])
template <class M, class Topic, class... A> boost::shared_ptr<const M> waitForMessage(const Topic& topic, const A&...);
} }
