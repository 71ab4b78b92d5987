// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/checks.h>
#include <waker/base/errors.h>
#include <waker/base/text.h>

#include "user_errors.h"
#include <cmath>
#include <gtest/gtest.h>

namespace base_text
{
  namespace
  {
    using namespace Waker;
    using Parts = std::vector<std::string>;


    TEST(Base, split_keeps_empty_parts_and_tidies_all)
    {
      EXPECT_EQ(tidy(" \t a  b\n"), "a b");
      EXPECT_EQ(split(" a;; b  c ;", ';'), Parts({"a", "", "b c", ""}));
      EXPECT_EQ(split("a, b", ';'), Parts({"a, b"}));
      EXPECT_EQ(split(" \t", ';'), Parts());
    }


    TEST(Base, alternatives_are_joined_for_a_message)
    {
      EXPECT_EQ(either({}), "");
      EXPECT_EQ(either({"a"}), "a");
      EXPECT_EQ(counted(1, "number"), "1 number");
      EXPECT_EQ(counted(0, "number"), "0 numbers");
      EXPECT_EQ(either({"a", "b"}), "a or b");
      EXPECT_EQ(either({"a", "b", "c"}), "a, b or c");
    }


    TEST(Base, require_positive_names_path_value_and_unit)
    {
      EXPECT_NO_THROW(require_positive("A/B", 1e-300));
      EXPECT_NO_THROW(require_between("A/B", 2., 1., 2.));
      EXPECT_USER_ERROR(require_between("A/B", 2.5, 1., 2., "m"),
                        "A/B",
                        "is 2.5 m");
      EXPECT_USER_ERROR(require_between("A/B", std::nan(""), 1., 2.),
                        "A/B",
                        "is nan");
      for (const double value : {0., -1., std::nan("")})
        EXPECT_USER_ERROR(require_positive("A/B", value), "A/B", "is ");
      try
        {
          require_positive("A/B", -2.5, "kPa");
          FAIL();
        }
      catch (const UserError &error)
        {
          EXPECT_EQ(error.where, "A/B");
          EXPECT_EQ(error.problem.rfind("is -2.5", 0), 0u) << error.problem;
          EXPECT_NE(error.problem.find(" kPa"), std::string::npos);
          EXPECT_EQ(error.allowed, "a number above 0");
        }
    }
  } // namespace
} // namespace base_text
