// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <stdexcept>
namespace tf2 {
class TransformException : public std::runtime_error { public: TransformException(const std::string&); };
class ConnectivityException : public TransformException { public: ConnectivityException(const std::string&); };
class LookupException : public TransformException { public: LookupException(const std::string&); };
class ExtrapolationException : public TransformException { public: ExtrapolationException(const std::string&); };
class InvalidArgumentException : public TransformException { public: InvalidArgumentException(const std::string&); };
class TimeoutException : public TransformException { public: TimeoutException(const std::string&); };
}
