// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
namespace boost {
template <class C = char> class char_separator { public: explicit char_separator(const C*, const C* = nullptr, int = 0); };
template <class C = char> class escaped_list_separator { public: template <class... A> escaped_list_separator(const A&...); };
enum empty_token_policy { drop_empty_tokens, keep_empty_tokens };
template <class S = char_separator<char>, class I = std::string::const_iterator, class T = std::string> class tokenizer {
public:
  typedef const T* iterator; typedef const T* const_iterator;
  template <class C> tokenizer(const C&); template <class C> tokenizer(const C&, const S&); iterator begin() const; iterator end() const;
};
}
