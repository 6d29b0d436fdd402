// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <list>
#include <boost/optional.hpp>
namespace boost { namespace property_tree {
class ptree_error : public std::exception {}; typedef ptree_error ptree_bad_path; typedef ptree_error ptree_bad_data;
class ptree { public: typedef std::pair<const std::string, ptree> value_type; typedef const value_type* const_iterator;
  typedef value_type* iterator; typedef const value_type* const_assoc_iterator;
  template <class T> T get(const std::string&) const; template <class T> T get(const std::string&, const T&) const;
    std::string get(const std::string&, const char*) const; template <class T> boost::optional<T> get_optional(const std::string&) const;
    template <class T> T get_value() const;
  template <class T> ptree& put(const std::string&, const T&); template <class T> ptree& add(const std::string&, const T&);
    ptree& add_child(const std::string&, const ptree&); ptree& get_child(const std::string&);
    const ptree& get_child(const std::string&) const; boost::optional<const ptree&> get_child_optional(const std::string&) const;
    ptree& put_child(const std::string&, const ptree&);
  iterator begin(); iterator end(); const_iterator begin() const; const_iterator end() const; iterator push_back(const value_type&);
    std::size_t count(const std::string&) const; std::size_t size() const; bool empty() const; std::string data() const;
    const_iterator find(const std::string&) const; const_iterator not_found() const; void clear(); };
template <class S> void read_json(S&&, ptree&); template <class S> void write_json(S&&, const ptree&, bool = true);
  template <class S> void read_xml(S&&, ptree&, int = 0); template <class S, class... X> void write_xml(S&&, const ptree&, X...);
  template <class S> void read_ini(S&&, ptree&); template <class S> void write_ini(S&&, const ptree&);
namespace json_parser { using property_tree::read_json; using property_tree::write_json; typedef ptree_error json_parser_error; }
  namespace xml_parser { using property_tree::read_xml; using property_tree::write_xml; typedef ptree_error xml_parser_error;
  enum { trim_whitespace = 2 }; } namespace ini_parser { using property_tree::read_ini; }
} }
