// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/message_prelude.h>
#include <xmlrpcpp/XmlRpcValue.h>
namespace ros { namespace master {
struct TopicInfo { TopicInfo(); TopicInfo(const std::string& name, const std::string& datatype); std::string name; std::string datatype; };
typedef std::vector<TopicInfo> V_TopicInfo;
bool check(); const std::string& getHost(); uint32_t getPort(); const std::string& getURI(); bool getTopics(V_TopicInfo&);
  bool getNodes(std::vector<std::string>&); void setRetryTimeout(WallDuration);
bool execute(const std::string&, const XmlRpc::XmlRpcValue&, XmlRpc::XmlRpcValue&, XmlRpc::XmlRpcValue&, bool);
} }
