// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <fstream>
namespace __gnu_cxx { template <class C> class stdio_filebuf : public std::basic_filebuf<C> { public: stdio_filebuf(int, int,
  std::size_t = 0); int fd(); }; }
