// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/message_prelude.h>
namespace ros {
class TransportHints {
public:
  TransportHints& reliable(); TransportHints& unreliable(); TransportHints& tcp(); TransportHints& udp();
  TransportHints& tcpNoDelay(bool = true); TransportHints& maxDatagramSize(int);
  bool getTCPNoDelay(); int getMaxDatagramSize(); const M_string& getOptions();
};
}
