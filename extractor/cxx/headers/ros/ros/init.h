// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <ros/message_prelude.h>
#include <ros/spinner.h>
namespace ros {
namespace init_options { enum InitOption { NoSigintHandler = 1, AnonymousName = 2, NoRosout = 4, NoSimTime = 8 }; }
typedef init_options::InitOption InitOption;
typedef std::vector<std::pair<std::string, std::string>> VP_string;
template <class Argv> void init(int& argc, Argv argv, const std::string& name, uint32_t options = 0);
void init(const M_string& remappings, const std::string& name, uint32_t options = 0);
void init(const VP_string& remappings, const std::string& name, uint32_t options = 0);
template <class Argv> void removeROSArgs(int argc, Argv argv, std::vector<std::string>& rest);
bool isInitialized();
bool isStarted();
bool isShuttingDown();
void start();
void shutdown();
void requestShutdown();
void waitForShutdown();
bool ok();
void spin();
void spin(Spinner&);
void spinOnce();
CallbackQueue* getGlobalCallbackQueue();
boost::shared_ptr<CallbackQueue> getInternalCallbackQueue();
std::string getROSArg(int, const char* const*, const std::string&);
std::string getDefaultMasterURI();
}
