// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>
#include <map>
#include <iosfwd>
#include <stdexcept>
namespace YAML {
struct Mark { int pos, line, column; }; class Exception : public std::runtime_error { public: Mark mark; std::string msg;
  Exception(const Mark&, const std::string&); }; typedef Exception ParserException; typedef Exception RepresentationException;
  typedef Exception InvalidNode; typedef Exception BadConversion; typedef Exception BadFile; typedef Exception TypedBadConversion;
  typedef Exception KeyNotFound; typedef Exception InvalidScalar;
struct NodeType { enum value { Undefined, Null, Scalar, Sequence, Map }; }; struct rosarch_entry;
template <class T> struct convert;
class Node {
public:
  typedef rosarch_entry* iterator; typedef const rosarch_entry* const_iterator; Node(); Node(const Node&); explicit Node(NodeType::value);
    template <class T> explicit Node(const T&); Node& operator=(const Node&); template <class T> Node& operator=(const T&);
  template <class K> Node operator[](const K&) const; template <class T> T as() const; template <class T, class D> T as(const D&) const;
    bool IsDefined() const; bool IsNull() const; bool IsScalar() const; bool IsSequence() const; bool IsMap() const;
    NodeType::value Type() const; explicit operator bool() const; bool operator!() const; std::size_t size() const;
    const std::string& Scalar() const; const std::string& Tag() const; Mark Mark() const; template <class T> void push_back(const T&);
    template <class K> bool remove(const K&); iterator begin(); iterator end(); const_iterator begin() const; const_iterator end() const;
    void reset();
  // The old interface of yaml-cpp 0.3.
  const Node* FindValue(const std::string&) const; template <class T> bool Read(T&) const; template <class T> T to() const;
    template <class T> friend void operator>>(const Node&, T&); std::string GetTag() const;
};
struct rosarch_entry : Node { Node first, second; operator std::pair<Node, Node>() const; rosarch_entry& operator*(); };
  typedef Node::iterator iterator; typedef Node::const_iterator const_iterator; typedef Node::const_iterator Iterator;
Node Load(const std::string&); Node Load(std::istream&); Node LoadFile(const std::string&); std::vector<Node> LoadAll(const std::string&);
  std::vector<Node> LoadAllFromFile(const std::string&); Node Clone(const Node&); std::string Dump(const Node&);
class Parser { public: Parser(); Parser(std::istream&); bool GetNextDocument(Node&); };
  enum EMITTER_MANIP { Auto, BeginSeq, EndSeq, BeginMap, EndMap, Key, Value, Flow, Block, Newline, BeginDoc, EndDoc, DoubleQuoted,
  SingleQuoted, Literal, Comment_ };
class Emitter { public: Emitter(); Emitter(std::ostream&); template <class T> Emitter& operator<<(const T&); const char* c_str() const;
  std::size_t size() const; bool good() const; std::string GetLastError() const; }; struct rosarch_comment {};
  rosarch_comment Comment(const std::string&);
}
