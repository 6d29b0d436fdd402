// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <string>
#include <vector>
namespace ros { namespace package {
typedef std::vector<std::string> V_string;
std::string command(const std::string&); std::string getPath(const std::string& package); bool getAll(V_string&);
void getPlugins(const std::string& package, const std::string& attribute, V_string&, bool = false);
  void getPlugins(const std::string&, const std::string&, std::map<std::string, std::string>&, bool = false);
} }
