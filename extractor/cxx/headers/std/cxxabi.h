// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
namespace abi { char* __cxa_demangle(const char*, char*, unsigned long*, int*); }
namespace __cxxabiv1 { using abi::__cxa_demangle; }
