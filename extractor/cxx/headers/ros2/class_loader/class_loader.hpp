// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>
#define CLASS_LOADER_REGISTER_CLASS_AT(C, B, line) CLASS_LOADER_REGISTER_CLASS_NAMED(C, B, line)
#define CLASS_LOADER_REGISTER_CLASS_NAMED(C, B, line) typedef C rosarch_class_##line; typedef B rosarch_class_base_##line;
#define CLASS_LOADER_REGISTER_CLASS(C, B) CLASS_LOADER_REGISTER_CLASS_AT(C, B, __LINE__)
namespace class_loader {
class ClassLoader { public: ClassLoader(const std::string& library, bool on_demand = false); template <class B> std::vector<std::string> getAvailableClasses(); template <class B> bool isClassAvailable(const std::string&);
  template <class B> std::shared_ptr<B> createInstance(const std::string&); template <class B> std::shared_ptr<B> createSharedInstance(const std::string&); template <class B> std::unique_ptr<B> createUniqueInstance(const std::string&);
  bool isLibraryLoaded(); void loadLibrary(); int unloadLibrary(); };
struct ClassLoaderException : public std::runtime_error { using std::runtime_error::runtime_error; };
}
