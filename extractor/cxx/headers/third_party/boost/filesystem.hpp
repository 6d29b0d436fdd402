// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <fstream>
#include <boost/system/error_code.hpp>
namespace boost { namespace filesystem {
using namespace std::filesystem;
using std::filesystem::path; using std::filesystem::directory_iterator; using std::filesystem::recursive_directory_iterator;
  using std::filesystem::exists; using std::filesystem::filesystem_error;
using std::ofstream; using std::ifstream; using std::fstream;
std::string basename(const path&); std::string extension(const path&); path change_extension(const path&, const std::string&);
  path system_complete(const path&); bool is_regular(const path&); path unique_path(const path& = path()); path initial_path();
  path complete(const path&);
} }
