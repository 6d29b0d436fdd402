// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/message_prelude.h>
namespace ros { namespace this_node {
const std::string& getName(); const std::string& getNamespace(); void getAdvertisedTopics(std::vector<std::string>&);
  void getSubscribedTopics(std::vector<std::string>&);
} }
