// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/node_handle.h>
namespace ros { namespace service {
template <class Name, class Service> bool call(const Name& name, Service& service);
template <class Name, class Request, class Response> bool call(const Name& name, const Request& request, Response& response);
bool exists(const std::string& name, bool print_failure_reason);
template <class Name> bool waitForService(const Name& name);
template <class Name, class Timeout> bool waitForService(const Name& name, const Timeout& timeout);
template <class S, class Name, class... A> ServiceClient createClient(const Name& name, const A&...);
} }
