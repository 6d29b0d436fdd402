// Stand-in header of rosarch: declarations only.  SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <iostream>
#include <rosarch/any.h>
// A test is a class with a method TestBody, as in the real header; every assertion keeps its arguments.
namespace testing {
class Test { public: virtual ~Test(); virtual void TestBody() = 0; static bool HasFailure(); static bool HasFatalFailure();
  protected: Test(); virtual void SetUp(); virtual void TearDown(); };
template <class T> class TestWithParam : public Test { public: typedef T ParamType; static const T& GetParam(); };
struct rosarch_message { template <class T> rosarch_message& operator<<(const T&);
  rosarch_message& operator<<(std::ostream& (*)(std::ostream&)); };
template <class... A> rosarch_message check(const A&...);
template <class C> void InitGoogleTest(int*, C**); void InitGoogleTest();
class Environment { public: virtual ~Environment(); virtual void SetUp(); virtual void TearDown(); };
  Environment* AddGlobalTestEnvironment(Environment*);
template <class... A> rosarch::any Values(const A&...); template <class A> rosarch::any ValuesIn(const A&);
  template <class... A> rosarch::any Range(const A&...); rosarch::any Bool(); template <class... A> rosarch::any Combine(const A&...);
  template <class... T> struct Types {}; class AssertionResult { public: operator bool() const;
  template <class T> AssertionResult& operator<<(const T&); }; AssertionResult AssertionSuccess(); AssertionResult AssertionFailure();
}
int RUN_ALL_TESTS();
#define ROSARCH_GTEST(suite, name, base) class suite##_##name##_Test : public base { void TestBody() override; }; \
  void suite##_##name##_Test::TestBody()
#define TEST(suite, name) ROSARCH_GTEST(suite, name, ::testing::Test)
#define TEST_F(fixture, name) ROSARCH_GTEST(fixture, name, fixture)
#define TEST_P(fixture, name) ROSARCH_GTEST(fixture, name, fixture)
#define TYPED_TEST_CASE(...) static_assert(true, "")
#define INSTANTIATE_TEST_CASE_P(prefix, suite, ...) static_assert(true, "")
#define INSTANTIATE_TEST_SUITE_P(prefix, suite, ...) static_assert(true, "")
#define EXPECT_TRUE(...) ::testing::check(__VA_ARGS__)
#define EXPECT_FALSE(...) ::testing::check(__VA_ARGS__)
#define EXPECT_EQ(...) ::testing::check(__VA_ARGS__)
#define EXPECT_NE(...) ::testing::check(__VA_ARGS__)
#define EXPECT_LT(...) ::testing::check(__VA_ARGS__)
#define EXPECT_LE(...) ::testing::check(__VA_ARGS__)
#define EXPECT_GT(...) ::testing::check(__VA_ARGS__)
#define EXPECT_GE(...) ::testing::check(__VA_ARGS__)
#define EXPECT_STREQ(...) ::testing::check(__VA_ARGS__)
#define EXPECT_STRNE(...) ::testing::check(__VA_ARGS__)
#define EXPECT_FLOAT_EQ(...) ::testing::check(__VA_ARGS__)
#define EXPECT_DOUBLE_EQ(...) ::testing::check(__VA_ARGS__)
#define EXPECT_NEAR(...) ::testing::check(__VA_ARGS__)
#define EXPECT_PRED1(...) ::testing::check(__VA_ARGS__)
#define EXPECT_PRED2(...) ::testing::check(__VA_ARGS__)
#define EXPECT_THROW(statement, ...) if (true) { statement; } else ::testing::check()
#define EXPECT_NO_THROW(statement, ...) if (true) { statement; } else ::testing::check()
#define EXPECT_ANY_THROW(statement, ...) if (true) { statement; } else ::testing::check()
#define EXPECT_DEATH(statement, ...) if (true) { statement; } else ::testing::check()
#define ASSERT_TRUE(...) ::testing::check(__VA_ARGS__)
#define ASSERT_FALSE(...) ::testing::check(__VA_ARGS__)
#define ASSERT_EQ(...) ::testing::check(__VA_ARGS__)
#define ASSERT_NE(...) ::testing::check(__VA_ARGS__)
#define ASSERT_LT(...) ::testing::check(__VA_ARGS__)
#define ASSERT_LE(...) ::testing::check(__VA_ARGS__)
#define ASSERT_GT(...) ::testing::check(__VA_ARGS__)
#define ASSERT_GE(...) ::testing::check(__VA_ARGS__)
#define ASSERT_STREQ(...) ::testing::check(__VA_ARGS__)
#define ASSERT_STRNE(...) ::testing::check(__VA_ARGS__)
#define ASSERT_FLOAT_EQ(...) ::testing::check(__VA_ARGS__)
#define ASSERT_DOUBLE_EQ(...) ::testing::check(__VA_ARGS__)
#define ASSERT_NEAR(...) ::testing::check(__VA_ARGS__)
#define ASSERT_PRED1(...) ::testing::check(__VA_ARGS__)
#define ASSERT_PRED2(...) ::testing::check(__VA_ARGS__)
#define ASSERT_THROW(statement, ...) if (true) { statement; } else ::testing::check()
#define ASSERT_NO_THROW(statement, ...) if (true) { statement; } else ::testing::check()
#define ASSERT_ANY_THROW(statement, ...) if (true) { statement; } else ::testing::check()
#define ASSERT_DEATH(statement, ...) if (true) { statement; } else ::testing::check()
#define SUCCEED() ::testing::check()
#define FAIL() return (void)::testing::check()
#define ADD_FAILURE() ::testing::check()
#define SCOPED_TRACE(message) ((void)(message))
