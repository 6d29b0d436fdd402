// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#define ROS_DEPRECATED
#define ROS_FORCE_INLINE inline
#define ROS_UNUSED(x) ((void)(x))
#define ROS_HELPER_IMPORT
#define ROS_HELPER_EXPORT
#define ROSCPP_DECL
#define ROS_STATIC_ASSERT(condition) static_assert(true, "")
