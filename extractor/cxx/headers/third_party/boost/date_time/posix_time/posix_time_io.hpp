// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <boost/date_time/posix_time/posix_time.hpp>
