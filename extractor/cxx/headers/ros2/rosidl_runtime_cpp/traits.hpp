// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
namespace rosidl_generator_traits { template <class T> const char* data_type(); template <class T> const char* name(); template <class T, class... A> std::string to_yaml(const T&, const A&...);
template <class T> struct is_message { static const bool value = true; }; template <class T> struct is_service { static const bool value = true; }; template <class T> struct is_action { static const bool value = true; }; }
