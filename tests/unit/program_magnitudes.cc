// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/program/magnitudes.h>

#include "user_errors.h"
#include <gtest/gtest.h>

namespace program_magnitudes
{
  using namespace Waker;


  // In numbers, lists, tables and expressions, but not in words.
  TEST(Magnitudes, NumbersThatNothingHasAreFound)
  {
    for (const std::string text : {"1e308",
                                   "-1e16",
                                   "1e-300",
                                   "1.5e-16",
                                   "0, 1e308",
                                   "0: 0, 28: 1e308",
                                   "1e308: 4",
                                   "2: 0, 1; 9, 1 | 1e300: 0, 1; 9, 1",
                                   "5 + 1e-300*depth",
                                   "exp(-(x/1e200)^2)",
                                   "1e400",
                                   "10000000000000000000"})
      EXPECT_TRUE(odd_magnitude(text)) << text;
    EXPECT_EQ(odd_magnitude("0: 1, 2: 1e300, 3: 1e308"), "1e300");
    for (const std::string text : {"",
                                   "0",
                                   "0.0",
                                   "-0.25, 1e15",
                                   "1e-15",
                                   "1e+15",
                                   "layer1e300: 0.5",
                                   "x1e300 + 1",
                                   "1e300m",
                                   "initial_strength/2.6",
                                   "0*t; free",
                                   "x > 1.e3 ? 2 : .5"})
      EXPECT_FALSE(odd_magnitude(text)) << text;
  }


  TEST(Magnitudes, NamesFilesAndDefaultsAreNotLookedAt)
  {
    const std::string any = "[Anything]", number = "[Double -MAX...MAX]";
    const auto        check = [](const DeclaredParameter &parameter) {
      check_magnitudes({parameter});
    };
    EXPECT_USER_ERROR(check({"A", "Rise", "1e300", "0", any, "Rise (m)"}),
                      "A/Rise",
                      "the number 1e300");
    EXPECT_USER_ERROR(check({"A", "E", "1e300", "0", number, "Stiffness"}),
                      "A/E",
                      "the number 1e300");
    EXPECT_NO_THROW(check({"A", "E", "1e300", "1e300", number, "Stiffness"}));
    EXPECT_NO_THROW(check({"A", "Names", "1e300", "", any, "Names of it"}));
    EXPECT_NO_THROW(check({"Output", "Directory", "1e300", "", any, "Folder"}));
    EXPECT_NO_THROW(
      check({"A", "File", "1e300", "", "[FileName (Type: input)]", "File"}));
  }
} // namespace program_magnitudes
