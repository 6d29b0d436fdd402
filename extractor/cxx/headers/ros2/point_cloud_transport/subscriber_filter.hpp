// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <point_cloud_transport/point_cloud_transport.hpp>
