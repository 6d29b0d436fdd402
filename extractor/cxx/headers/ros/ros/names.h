// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/message_prelude.h>
namespace ros { namespace names {
std::string clean(const std::string&); std::string resolve(const std::string& name, bool remap = true);
  std::string resolve(const std::string& ns, const std::string& name, bool remap = true);
std::string append(const std::string&, const std::string&); std::string remap(const std::string&);
  bool validate(const std::string&, std::string& error);
const M_string& getRemappings(); const M_string& getUnresolvedRemappings(); std::string parentNamespace(const std::string&);
} }
