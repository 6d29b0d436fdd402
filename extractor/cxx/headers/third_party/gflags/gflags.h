// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <string>
// a flag is a global variable that begins with its default
#define DEFINE_bool(name, value, help) bool FLAGS_##name = value
#define DEFINE_int32(name, value, help) int FLAGS_##name = value
#define DEFINE_uint32(name, value, help) unsigned int FLAGS_##name = value
#define DEFINE_int64(name, value, help) long FLAGS_##name = value
#define DEFINE_uint64(name, value, help) unsigned long FLAGS_##name = value
#define DEFINE_double(name, value, help) double FLAGS_##name = value
#define DEFINE_string(name, value, help) std::string FLAGS_##name = value
#define DECLARE_bool(name) extern bool FLAGS_##name
#define DECLARE_int32(name) extern int FLAGS_##name
#define DECLARE_uint32(name) extern unsigned int FLAGS_##name
#define DECLARE_int64(name) extern long FLAGS_##name
#define DECLARE_uint64(name) extern unsigned long FLAGS_##name
#define DECLARE_double(name) extern double FLAGS_##name
#define DECLARE_string(name) extern std::string FLAGS_##name
#define DEFINE_validator(name, validator) static const bool name##_validator_registered = ::gflags::RegisterFlagValidator(&FLAGS_##name, validator)
namespace gflags {
std::uint32_t ParseCommandLineFlags(int* argc, char*** argv, bool remove_flags);
std::uint32_t ParseCommandLineNonHelpFlags(int* argc, char*** argv, bool remove_flags);
void HandleCommandLineHelpFlags();
void ShutDownCommandLineFlags();
void AllowCommandLineReparsing();
void SetUsageMessage(const std::string& usage);
void SetVersionString(const std::string& version);
const char* ProgramUsage();
const char* ProgramInvocationShortName();
const char* GetArgv0();
void ShowUsageWithFlags(const char* argv0);
void ShowUsageWithFlagsRestrict(const char* argv0, const char* restriction);
std::string SetCommandLineOption(const char* name, const char* value);
bool GetCommandLineOption(const char* name, std::string* value);
template <typename T> bool RegisterFlagValidator(const T* flag, bool (*validator)(const char*, T));
template <typename T> bool RegisterFlagValidator(const T* flag, bool (*validator)(const char*, const T&));
}  // namespace gflags
namespace google {
using namespace gflags;
}
