// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <cstdio>
class TiXmlElement; class TiXmlAttribute { public: const char* Name() const; const char* Value() const; int IntValue() const;
  double DoubleValue() const; TiXmlAttribute* Next() const; };
class TiXmlNode { public: virtual ~TiXmlNode(); const char* Value() const; const std::string& ValueStr() const; void SetValue(const char*);
  TiXmlNode* FirstChild(const char* = 0) const; TiXmlNode* LastChild() const; TiXmlNode* NextSibling(const char* = 0) const;
  TiXmlElement* FirstChildElement(const char* = 0) const; TiXmlElement* FirstChildElement(const std::string&) const;
  TiXmlElement* NextSiblingElement(const char* = 0) const; TiXmlElement* NextSiblingElement(const std::string&) const;
  TiXmlNode* Parent() const; TiXmlElement* ToElement() const; TiXmlNode* IterateChildren(const TiXmlNode*) const;
  TiXmlNode* IterateChildren(const char*, const TiXmlNode*) const; template <class T> TiXmlNode* InsertEndChild(const T&);
  TiXmlNode* LinkEndChild(TiXmlNode*); bool NoChildren() const; void Clear(); int Row() const; int Type() const;
  class TiXmlText* ToText() const; };
class TiXmlElement : public TiXmlNode { public: TiXmlElement(const char*); TiXmlElement(const std::string&);
  const char* Attribute(const char*) const; const char* Attribute(const char*, int*) const;
  const char* Attribute(const char*, double*) const; const std::string* Attribute(const std::string&) const;
  template <class T> int QueryIntAttribute(const T&, int*) const; template <class T> int QueryDoubleAttribute(const T&, double*) const;
  template <class T> int QueryFloatAttribute(const T&, float*) const; template <class T> int QueryStringAttribute(const char*, T*) const;
  template <class T> int QueryValueAttribute(const std::string&, T*) const; template <class T> void SetAttribute(const T&, const char*);
  template <class T> void SetAttribute(const T&, int); template <class T> void SetAttribute(const T&, const std::string&);
  void SetDoubleAttribute(const char*, double); const char* GetText() const; TiXmlAttribute* FirstAttribute() const; };
class TiXmlDocument : public TiXmlNode { public: TiXmlDocument(); explicit TiXmlDocument(const char*);
  explicit TiXmlDocument(const std::string&); bool LoadFile(int = 0); bool LoadFile(const char*, int = 0);
  bool LoadFile(const std::string&, int = 0); bool SaveFile(const char*) const; bool SaveFile(const std::string&) const;
  const char* Parse(const char*, void* = 0, int = 0); TiXmlElement* RootElement() const; bool Error() const; const char* ErrorDesc() const;
  int ErrorRow() const; int ErrorCol() const; void Print() const; };
class TiXmlText : public TiXmlNode { public: TiXmlText(const std::string&); };
  class TiXmlComment : public TiXmlNode { public: TiXmlComment(const char* = ""); };
  class TiXmlDeclaration : public TiXmlNode { public: TiXmlDeclaration(const char*, const char*, const char*); };
  class TiXmlHandle { public: TiXmlHandle(TiXmlNode*); TiXmlHandle FirstChild(const char* = "") const;
  TiXmlHandle FirstChildElement(const char* = "") const; TiXmlHandle Child(const char*, int) const; TiXmlElement* ToElement() const;
  TiXmlElement* Element() const; TiXmlText* Text() const; }; class TiXmlPrinter { public: const char* CStr() const; };
