// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>
#include <iosfwd>
namespace Json {
enum ValueType { nullValue, intValue, uintValue, realValue, stringValue, booleanValue, arrayValue, objectValue };
class Value { public: typedef Value* iterator; typedef const Value* const_iterator; typedef std::vector<std::string> Members;
  Value(ValueType = nullValue); template <class T> Value(const T&); Value(const Value&); Value& operator=(const Value&);
  Value& operator[](const char*); Value& operator[](const std::string&); Value& operator[](int); Value& operator[](unsigned);
  const Value& operator[](const char*) const; const Value& operator[](const std::string&) const; const Value& operator[](int) const;
  int asInt() const; unsigned asUInt() const; double asDouble() const; float asFloat() const; bool asBool() const;
  std::string asString() const; const char* asCString() const; bool isMember(const std::string&) const; bool isNull() const;
  bool isArray() const; bool isObject() const; bool isString() const; bool isInt() const; bool isDouble() const; bool isNumeric() const;
  bool isBool() const; std::size_t size() const; bool empty() const; Value& append(const Value&);
  Value get(const std::string&, const Value&) const; Members getMemberNames() const; std::string toStyledString() const; iterator begin();
  iterator end(); const_iterator begin() const; const_iterator end() const; void clear(); void resize(unsigned); ValueType type() const;
  explicit operator bool() const; };
class Reader { public: template <class... A> bool parse(A&&...); std::string getFormattedErrorMessages() const;
  std::string getFormatedErrorMessages() const; }; class FastWriter { public: std::string write(const Value&); };
  class StyledWriter { public: std::string write(const Value&); };
  class StyledStreamWriter { public: template <class S> void write(S&, const Value&); }; typedef Reader CharReader;
  class CharReaderBuilder { public: Value& operator[](const std::string&); };
template <class... A> bool parseFromStream(A&&...);
}
