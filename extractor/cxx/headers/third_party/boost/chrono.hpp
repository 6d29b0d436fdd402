// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <chrono>
namespace boost { namespace chrono {
using std::chrono::duration; using std::chrono::time_point; using std::chrono::duration_cast; using std::chrono::system_clock;
  using std::chrono::steady_clock; using std::chrono::high_resolution_clock;
using std::chrono::nanoseconds; using std::chrono::microseconds; using std::chrono::milliseconds; using std::chrono::seconds;
  using std::chrono::minutes; using std::chrono::hours;
typedef steady_clock process_real_cpu_clock; typedef steady_clock thread_clock;
} }
