// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#define BOOST_ASSERT(expression) ((void)(expression))
#define BOOST_ASSERT_MSG(expression, message) ((void)(expression), (void)(message))
#define BOOST_VERIFY(expression) ((void)(expression))
#define BOOST_STATIC_ASSERT(...) static_assert(true, "")
#define BOOST_STATIC_ASSERT_MSG(...) static_assert(true, "")
#define BOOST_THROW_EXCEPTION(x) throw x
namespace boost { template <class E> [[noreturn]] void throw_exception(const E&); }
