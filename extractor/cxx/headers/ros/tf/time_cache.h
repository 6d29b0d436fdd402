// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <tf/transform_datatypes.h>
namespace tf { class TimeCache {}; class TransformStorage {}; }
