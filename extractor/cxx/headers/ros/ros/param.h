// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/node_handle.h>
namespace ros { namespace param {
template <class Key, class V> void set(const Key& key, const V& value);
template <class Key, class V> bool get(const Key& key, V&& value);
template <class Key, class V> bool getCached(const Key& key, V&& value);
template <class Key> bool has(const Key& key);
template <class Key> bool del(const Key& key);
template <class Key> bool search(const Key& key, std::string& result);
template <class Ns, class Key> bool search(const Ns& ns, const Key& key, std::string& result);
bool getParamNames(std::vector<std::string>& keys);
template <class T = void, class Key, class V, class Default = typename std::decay<V>::type> bool param(const Key& key, V&& variable,
  const Default& default_value);
template <class T = void, class Key, class Default> typename rosarch_param<T, Default>::type param(const Key& key,
  const Default& default_value);
} }
