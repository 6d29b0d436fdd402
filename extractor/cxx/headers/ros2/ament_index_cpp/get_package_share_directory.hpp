// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>
namespace ament_index_cpp {
std::string get_package_share_directory(const std::string& package_name); std::string get_package_prefix(const std::string& package_name); std::filesystem::path get_package_share_path(const std::string&);
void get_package_share_path(const std::string&, std::filesystem::path&); std::map<std::string, std::string> get_resources(const std::string&); template <class... A> bool get_resource(const A&...);
template <class... A> bool has_resource(const A&...); std::map<std::string, std::string> get_packages_with_prefixes(); struct PackageNotFoundError : public std::exception {};
}
