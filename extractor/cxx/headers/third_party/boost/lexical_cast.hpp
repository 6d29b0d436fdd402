// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <typeinfo>
namespace boost {
class bad_lexical_cast : public std::bad_cast { public: const char* what() const noexcept override; };
template <class T, class S> T lexical_cast(const S&);
template <class T, class C> T lexical_cast(const C*, std::size_t);
namespace conversion { template <class T, class S> bool try_lexical_convert(const S&, T&); }
}
