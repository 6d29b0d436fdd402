// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rclcpp/rclcpp.hpp>
namespace autoware_utils_logging { class LoggerLevelConfigure { public: template <class N> explicit LoggerLevelConfigure(N* node); }; template <class N> class BasicLoggerLevelConfigure { public: explicit BasicLoggerLevelConfigure(N* node); }; }
