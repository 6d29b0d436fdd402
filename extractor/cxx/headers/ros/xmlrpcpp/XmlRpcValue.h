// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <map>
#include <string>
#include <vector>
#include <ctime>
#include <rosarch/any.h>
namespace XmlRpc {
class XmlRpcValue {
public:
  enum Type { TypeInvalid, TypeBoolean, TypeInt, TypeDouble, TypeString, TypeDateTime, TypeBase64, TypeArray, TypeStruct };
  typedef std::vector<char> BinaryData;
  typedef std::vector<XmlRpcValue> ValueArray;
  typedef std::map<std::string, XmlRpcValue> ValueStruct;
  typedef ValueStruct::iterator iterator;
  typedef ValueStruct::const_iterator const_iterator;
  XmlRpcValue();
  XmlRpcValue(bool); XmlRpcValue(int); XmlRpcValue(double); XmlRpcValue(const std::string&); XmlRpcValue(const char*);
    XmlRpcValue(std::tm*); XmlRpcValue(void*, int);
  XmlRpcValue(const XmlRpcValue&);
  ~XmlRpcValue();
  XmlRpcValue& operator=(const XmlRpcValue&); XmlRpcValue& operator=(const int&); XmlRpcValue& operator=(const double&);
    XmlRpcValue& operator=(const char*); XmlRpcValue& operator=(const std::string&); XmlRpcValue& operator=(bool);
  bool operator==(const XmlRpcValue&) const; bool operator!=(const XmlRpcValue&) const;
  operator bool&(); operator int&(); operator double&(); operator std::string&(); operator BinaryData&(); operator std::tm&();
  operator const bool&() const; operator const int&() const; operator const double&() const; operator const std::string&() const;
  XmlRpcValue& operator[](int); const XmlRpcValue& operator[](int) const; XmlRpcValue& operator[](const std::string&);
    XmlRpcValue& operator[](const char*); const XmlRpcValue& operator[](const std::string&) const;
    const XmlRpcValue& operator[](const char*) const;
  iterator begin(); iterator end(); const_iterator begin() const; const_iterator end() const;
  bool valid() const; const Type& getType() const; int size() const; void setSize(int); void clear();
    bool hasMember(const std::string&) const;
  std::string toXml() const; bool fromXml(const std::string&, int*); template <class S> S& write(S&) const;
protected:
  // Part of the interface in effect: code derives from this class to build arrays and structs.
  Type _type;
  union { bool asBool; int asInt; double asDouble; std::tm* asTime; std::string* asString; BinaryData* asBinary; ValueArray* asArray;
    ValueStruct* asStruct; } _value;
};
class XmlRpcException { public: XmlRpcException(const std::string&, int = -1); const std::string& getMessage() const; int getCode() const;
  };
class XmlRpcServer; class XmlRpcServerMethod;
class XmlRpcClient { public: XmlRpcClient(const char*, int, const char* = nullptr);
  bool execute(const char*, const XmlRpcValue&, XmlRpcValue&); void close(); };
}
