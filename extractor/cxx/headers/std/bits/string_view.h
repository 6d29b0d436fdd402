// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <bits/iterator.h>
namespace std {
template <class C> struct char_traits {
  typedef C char_type;
  typedef int int_type;
  typedef long off_type;
  typedef long pos_type;
  static size_t length(const C*);
  static int eof();
  static int compare(const C*, const C*, size_t);
  static C* copy(C*, const C*, size_t);
  static bool eq(C, C);
  static bool lt(C, C);
  static C to_char_type(int);
  static int to_int_type(C);
  static int not_eof(int);
  static bool eq_int_type(int, int);
};
template <class C, class Traits = char_traits<C>> class basic_string_view {
public:
  typedef C value_type;
  typedef const C* const_iterator;
  typedef const C* iterator;
  typedef size_t size_type;
  static constexpr size_t npos = size_t(-1);
  constexpr basic_string_view() noexcept {}
  constexpr basic_string_view(const C*) {}
  constexpr basic_string_view(const C*, size_t) {}
  const C* begin() const; const C* end() const;
  const C& operator[](size_t) const; const C& at(size_t) const; const C& front() const; const C& back() const;
  const C* data() const; size_t size() const; size_t length() const; bool empty() const;
  void remove_prefix(size_t); void remove_suffix(size_t);
  basic_string_view substr(size_t = 0, size_t = npos) const;
  size_t find(basic_string_view, size_t = 0) const; size_t find(C, size_t = 0) const;
  size_t rfind(basic_string_view, size_t = npos) const; size_t rfind(C, size_t = npos) const;
  int compare(basic_string_view) const;
};
typedef basic_string_view<char> string_view;
// Not templates: a string and a literal convert to the view.
bool operator==(string_view, string_view);
bool operator!=(string_view, string_view);
bool operator<(string_view, string_view);
}
