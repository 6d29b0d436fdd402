// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <joint_limits_interface/joint_limits_interface.h>
