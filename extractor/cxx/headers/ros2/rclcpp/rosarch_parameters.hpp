// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <rclcpp/rosarch_time.hpp>
#include <rclcpp/rosarch_qos.hpp>
#include <rcl_interfaces/msg/list_parameters_result.hpp>
#include <rcl_interfaces/msg/parameter.hpp>
#include <rcl_interfaces/msg/parameter_descriptor.hpp>
#include <rcl_interfaces/msg/parameter_event.hpp>
#include <rcl_interfaces/msg/parameter_type.hpp>
#include <rcl_interfaces/msg/set_parameters_result.hpp>
namespace rclcpp {
enum ParameterType : uint8_t { PARAMETER_NOT_SET, PARAMETER_BOOL, PARAMETER_INTEGER, PARAMETER_DOUBLE, PARAMETER_STRING, PARAMETER_BYTE_ARRAY,
  PARAMETER_BOOL_ARRAY, PARAMETER_INTEGER_ARRAY, PARAMETER_DOUBLE_ARRAY, PARAMETER_STRING_ARRAY };
std::string to_string(ParameterType);
std::ostream& operator<<(std::ostream&, ParameterType);
class ParameterValue {
public:
  ParameterValue(); ParameterValue(const ParameterValue&); ParameterValue& operator=(const ParameterValue&);
  template <class T> explicit ParameterValue(const T& value);
  ParameterType get_type() const; rcl_interfaces::msg::ParameterValue to_value_msg() const;
  bool operator==(const ParameterValue&) const; bool operator!=(const ParameterValue&) const;
  template <class T> T get() const; template <ParameterType T> rosarch::any get() const;
};
std::string to_string(const ParameterValue&);
class Parameter {
public:
  typedef std::shared_ptr<Parameter> SharedPtr;
  Parameter(); explicit Parameter(const std::string& name); Parameter(const Parameter&); Parameter& operator=(const Parameter&);
  template <class V> Parameter(const std::string& name, const V& value);
  ParameterType get_type() const; std::string get_type_name() const; const std::string& get_name() const;
  rcl_interfaces::msg::ParameterValue get_value_message() const; const ParameterValue& get_parameter_value() const;
  template <class T> T get_value() const; template <ParameterType T> rosarch::any get_value() const;
  bool as_bool() const; int64_t as_int() const; double as_double() const; const std::string& as_string() const;
  const std::vector<uint8_t>& as_byte_array() const; const std::vector<bool>& as_bool_array() const; const std::vector<int64_t>& as_integer_array() const;
  const std::vector<double>& as_double_array() const; const std::vector<std::string>& as_string_array() const;
  static Parameter from_parameter_msg(const rcl_interfaces::msg::Parameter&); rcl_interfaces::msg::Parameter to_parameter_msg() const;
  std::string value_to_string() const; bool operator==(const Parameter&) const; bool operator!=(const Parameter&) const;
};
std::ostream& operator<<(std::ostream&, const Parameter&);
std::ostream& operator<<(std::ostream&, const std::vector<Parameter>&);
typedef std::map<std::string, std::vector<Parameter>> ParameterMap;
template <class... A> ParameterMap parameter_map_from_yaml_file(const A&...);
template <class... A> ParameterMap parameter_map_from(const A&...);
template <class... A> std::vector<Parameter> parameters_from_map(const A&...);
namespace exceptions {
struct ParameterNotDeclaredException : public std::runtime_error { using std::runtime_error::runtime_error; };
struct ParameterAlreadyDeclaredException : public std::runtime_error { using std::runtime_error::runtime_error; };
struct ParameterUninitializedException : public std::runtime_error { using std::runtime_error::runtime_error; };
struct ParameterImmutableException : public std::runtime_error { using std::runtime_error::runtime_error; };
struct ParameterModifiedInCallbackException : public std::runtime_error { using std::runtime_error::runtime_error; };
struct InvalidParametersException : public std::runtime_error { using std::runtime_error::runtime_error; };
struct InvalidParameterValueException : public std::runtime_error { using std::runtime_error::runtime_error; };
struct InvalidParameterTypeException : public std::runtime_error { InvalidParameterTypeException(const std::string&, const std::string); };
struct InvalidNodeNameError : public std::runtime_error { using std::runtime_error::runtime_error; };
struct InvalidTopicNameError : public std::runtime_error { using std::runtime_error::runtime_error; };
struct InvalidServiceNameError : public std::runtime_error { using std::runtime_error::runtime_error; };
struct RCLError : public std::runtime_error { using std::runtime_error::runtime_error; };
struct UnknownTypeError : public std::runtime_error { using std::runtime_error::runtime_error; };
struct UnknownROSArgsError : public std::runtime_error { using std::runtime_error::runtime_error; };
struct InvalidQosOverridesException : public std::runtime_error { using std::runtime_error::runtime_error; };
template <class... A> void throw_from_rcl_error(const A&...);
struct InvalidEventError : public std::runtime_error { using std::runtime_error::runtime_error; };
}
struct ParameterTypeException : public std::runtime_error { using std::runtime_error::runtime_error; };
struct ParameterEventsFilter { enum class EventType { NEW, DELETED, CHANGED }; template <class... A> ParameterEventsFilter(const A&...);
  const std::vector<std::pair<EventType, rcl_interfaces::msg::Parameter*>>& get_events() const; };
}
