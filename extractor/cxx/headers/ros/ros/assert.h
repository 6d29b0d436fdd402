// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/console.h>
#define ROS_ASSERT(condition) ((void)(condition))
#define ROS_ASSERT_MSG(condition, ...) ((void)(condition), ::ros::console::print(::ros::console::levels::Fatal, __VA_ARGS__))
#define ROS_ASSERT_CMD(condition, command) ((condition) ? (void)0 : (void)(command))
#define ROS_ASSERT_ENABLED 1
#define ROS_BREAK() ((void)0)
#define ROS_ISSUE_BREAK() ((void)0)
