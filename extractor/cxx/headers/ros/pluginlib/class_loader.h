// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <boost/shared_ptr.hpp>
#include <memory>
#include <ros/console.h>
#include <stdexcept>
#include <string>
#include <vector>
namespace pluginlib {
class PluginlibException : public std::runtime_error { public: PluginlibException(const std::string&); };
class LibraryLoadException : public PluginlibException { public: using PluginlibException::PluginlibException; };
class CreateClassException : public PluginlibException { public: using PluginlibException::PluginlibException; };
class ClassLoaderException : public PluginlibException { public: using PluginlibException::PluginlibException; };
class LibraryUnloadException : public PluginlibException { public: using PluginlibException::PluginlibException; };
template <class T> using UniquePtr = std::unique_ptr<T>;
template <class T> class ClassLoader {
public:
  ClassLoader(const std::string& package, const std::string& base_class, const std::string& attribute = "plugin",
    const std::vector<std::string>& = std::vector<std::string>());
  ~ClassLoader();
  boost::shared_ptr<T> createInstance(const std::string& name); std::shared_ptr<T> createSharedInstance(const std::string& name);
    UniquePtr<T> createUniqueInstance(const std::string& name); T* createUnmanagedInstance(const std::string& name);
    T* createClassInstance(const std::string&, bool = true);
  std::vector<std::string> getDeclaredClasses(); std::vector<std::string> getRegisteredLibraries(); std::string getName(const std::string&);
    std::string getBaseClassType() const; std::string getClassType(const std::string&); std::string getClassDescription(const std::string&);
    std::string getClassPackage(const std::string&); bool isClassAvailable(const std::string&); bool isClassLoaded(const std::string&);
    void loadLibraryForClass(const std::string&); int unloadLibraryForClass(const std::string&); void refreshDeclaredClasses();
};
}
namespace class_loader { class ClassLoader { public: explicit ClassLoader(const std::string&, bool = false);
  template <class T> boost::shared_ptr<T> createInstance(const std::string&);
  template <class T> std::vector<std::string> getAvailableClasses(); };
  class MultiLibraryClassLoader : public ClassLoader { public: explicit MultiLibraryClassLoader(bool); }; }
