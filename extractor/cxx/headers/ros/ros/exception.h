// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stdexcept>
namespace ros {
class Exception : public std::runtime_error { public: Exception(const std::string&); };
#define ROSARCH_EXCEPTION(name) class name : public Exception { public: name(const std::string&); };
ROSARCH_EXCEPTION(InvalidNodeNameException) ROSARCH_EXCEPTION(InvalidNameException) ROSARCH_EXCEPTION(ConflictingSubscriptionException)
ROSARCH_EXCEPTION(InvalidParameterException) ROSARCH_EXCEPTION(InvalidPortException) ROSARCH_EXCEPTION(StreamOverrunException)
#undef ROSARCH_EXCEPTION
}
