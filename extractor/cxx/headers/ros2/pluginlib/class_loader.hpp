// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <string>
#include <vector>
#include <stdexcept>
#include <class_loader/class_loader.hpp>
#define PLUGINLIB_EXPORT_CLASS_AT(C, B, line) PLUGINLIB_EXPORT_CLASS_NAMED(C, B, line)
#define PLUGINLIB_EXPORT_CLASS_NAMED(C, B, line) typedef C rosarch_plugin_##line; typedef B rosarch_plugin_base_##line;
#define PLUGINLIB_EXPORT_CLASS(C, B) PLUGINLIB_EXPORT_CLASS_AT(C, B, __LINE__)
namespace pluginlib {
struct PluginlibException : public std::runtime_error { using std::runtime_error::runtime_error; };
struct LibraryLoadException : public PluginlibException { using PluginlibException::PluginlibException; }; struct ClassLoaderException : public PluginlibException { using PluginlibException::PluginlibException; };
struct LibraryUnloadException : public PluginlibException { using PluginlibException::PluginlibException; }; struct CreateClassException : public PluginlibException { using PluginlibException::PluginlibException; };
template <class T> using UniquePtr = std::unique_ptr<T>;
template <class T> class ClassLoader { public: template <class... A> ClassLoader(const std::string& package, const std::string& base_class, const A&...); ~ClassLoader();
  std::shared_ptr<T> createSharedInstance(const std::string& lookup_name); std::unique_ptr<T> createUniqueInstance(const std::string& lookup_name); T* createUnmanagedInstance(const std::string& lookup_name);
  std::vector<std::string> getDeclaredClasses(); bool isClassAvailable(const std::string&); std::string getName(const std::string&); std::string getClassType(const std::string&); std::string getClassDescription(const std::string&);
  std::string getBaseClassType() const; std::string getClassPackage(const std::string&); std::string getPluginManifestPath(const std::string&); std::vector<std::string> getRegisteredLibraries(); bool isClassLoaded(const std::string&);
  void loadLibraryForClass(const std::string&); int unloadLibraryForClass(const std::string&); void refreshDeclaredClasses(); };
}
