// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>
#include <map>
#include <stdexcept>
#include <typeinfo>
namespace boost {
class any { public: any(); template <class T> any(const T&); bool empty() const; const std::type_info& type() const; };
template <class T> T any_cast(const any&); template <class T> T* any_cast(any*); class bad_any_cast : public std::exception {};
namespace program_options {
class error : public std::logic_error { public: using std::logic_error::logic_error; }; typedef error invalid_option_value;
  typedef error required_option; typedef error unknown_option;
struct value_semantic { template <class T> value_semantic* default_value(const T&);
  template <class T, class U> value_semantic* default_value(const T&, const U&);
  template <class T> value_semantic* implicit_value(const T&); value_semantic* required(); value_semantic* multitoken();
  value_semantic* composing(); template <class F> value_semantic* notifier(const F&); value_semantic* zero_tokens();
  value_semantic* value_name(const std::string&); };
template <class T> value_semantic* value(); template <class T> value_semantic* value(T*); value_semantic* bool_switch();
  value_semantic* bool_switch(bool*);
class options_description_easy_init { public: template <class... A> options_description_easy_init& operator()(const A&...); };
class options_description { public: template <class... A> explicit options_description(const A&...);
  options_description_easy_init add_options(); options_description& add(const options_description&); };
class positional_options_description { public: positional_options_description& add(const char*, int); };
class variable_value { public: template <class T> const T& as() const; bool empty() const; bool defaulted() const; };
class variables_map : public std::map<std::string, variable_value> { public: const variable_value& operator[](const std::string&) const; };
struct parsed_options {};
class command_line_parser { public: template <class... A> command_line_parser(const A&...);
  command_line_parser& options(const options_description&); command_line_parser& positional(const positional_options_description&);
  command_line_parser& allow_unregistered(); command_line_parser& style(int); parsed_options run(); };
template <class... A> parsed_options parse_command_line(const A&...); template <class... A> parsed_options parse_config_file(const A&...);
  void store(const parsed_options&, variables_map&); void notify(variables_map&);
}
}
