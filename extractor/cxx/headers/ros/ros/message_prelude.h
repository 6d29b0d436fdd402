// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
// All that a generated message header includes.
#include <boost/array.hpp>
#include <boost/shared_ptr.hpp>
#include <ros/time.h>
#include <cstdint>
#include <iosfwd>
#include <map>
#include <set>
#include <string>
#include <vector>
namespace ros {
typedef std::vector<std::string> V_string;
typedef std::set<std::string> S_string;
typedef std::map<std::string, std::string> M_string; typedef boost::shared_ptr<M_string> M_stringPtr;
}
