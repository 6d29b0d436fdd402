// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#define BOOST_VERSION 107100
#define BOOST_LIB_VERSION "1_71"
#define BOOST_CONSTEXPR constexpr
#define BOOST_NOEXCEPT noexcept
#define BOOST_OVERRIDE override
#define BOOST_FORCEINLINE inline
#define BOOST_SYMBOL_EXPORT
#define BOOST_SYMBOL_IMPORT
#define BOOST_SYMBOL_VISIBLE
#define BOOST_LIKELY(x) (x)
#define BOOST_UNLIKELY(x) (x)
#define BOOST_PP_CAT(a, b) a##b
#define BOOST_STRINGIZE(x) #x
#define BOOST_CURRENT_FUNCTION __func__
#define BOOST_AUTO(variable, expression) auto variable = expression
#define BOOST_TYPEOF(expression) decltype(expression)
