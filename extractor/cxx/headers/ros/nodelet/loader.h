// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <nodelet/nodelet.h>
namespace nodelet { class Loader { public: Loader(bool = true); Loader(const ros::NodeHandle&);
  bool load(const std::string& name, const std::string& type, const ros::M_string& remappings, const std::vector<std::string>& argv);
  bool unload(const std::string&); bool clear(); std::vector<std::string> listLoadedNodelets(); }; }
