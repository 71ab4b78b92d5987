// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_user_errors_h
#define waker_tests_user_errors_h

#include <waker/base/errors.h>

#include <gtest/gtest.h>
#include <string>

namespace Waker
{
  /**
   * The three lines of the UserError that `function` must throw: `where` is
   * exactly that of the first one, the second one contains `problem`, the third
   * one is not empty. Another exception than a UserError fails the test, too.
   */
  template <typename Function>
  void
  expect_user_error(const Function    &function,
                    const std::string &where,
                    const std::string &problem)
  {
    ASSERT_FALSE(problem.empty()) << "any text contains nothing";
    try
      {
        function();
      }
    catch (const UserError &error)
      {
        EXPECT_EQ(error.where, where) << error.what();
        EXPECT_NE(error.problem.find(problem), std::string::npos)
          << "\"" << problem << "\" is not in: " << error.what();
        EXPECT_FALSE(error.allowed.empty()) << error.what();
        return;
      }
    ADD_FAILURE() << "no error at " << where << ": " << problem;
  }
} // namespace Waker

/// expect_user_error() of an expression.
#define EXPECT_USER_ERROR(expression, where_, problem_)         \
  do                                                            \
    {                                                           \
      SCOPED_TRACE(#expression);                                \
      ::Waker::expect_user_error([&]() { (void)(expression); }, \
                                 where_,                        \
                                 problem_);                     \
  } while (false)

#endif
