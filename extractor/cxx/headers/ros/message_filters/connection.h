// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <boost/function.hpp>
#include <boost/signals2.hpp>
namespace message_filters { class Connection { public: Connection(); template <class... A> explicit Connection(const A&...);
  void disconnect(); }; }
