// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/expression_pattern.h>
#include <waker/base/named_expression.h>

#include <gtest/gtest.h>

namespace base_named_expression
{
  namespace
  {
    using namespace Waker;

    const std::vector<std::string> names = {"a",
                                            "b",
                                            "depth",
                                            "depth_in_layer",
                                            "e"};

    TEST(Base, expression_reads_the_variables_that_it_names)
    {
      const double          values[] = {2., 3., 5., 7., 11.};
      const NamedExpression e("depth_in_layer - a*e + pi*b", "path", names);
      EXPECT_DOUBLE_EQ(e.value(values), 7. - 22. + 3. * 3.14159265358979312);
      EXPECT_TRUE(e.uses(0));
      EXPECT_FALSE(e.uses(2)) << "depth is only the beginning of a name";
      EXPECT_DOUBLE_EQ(
        NamedExpression("1.5*depth", "path", names).value(values), 7.5);
      EXPECT_DOUBLE_EQ(NamedExpression("6", "path", names).value(values), 6.);
    }


    TEST(Base, expression_of_anything_else_is_refused)
    {
      for (const char *const bad :
           {"c", "a +", "", "unused3", "t", "a+b+e+depth+depth_in_layer"})
        try
          {
            NamedExpression(bad, "Section/Name", names, ", or a number");
            ADD_FAILURE() << bad;
          }
        catch (const UserError &error)
          {
            EXPECT_EQ(error.where, "Section/Name");
            EXPECT_NE(error.allowed.find("depth_in_layer"), std::string::npos);
            EXPECT_NE(error.allowed.find(", or a number"), std::string::npos);
          }
    }


    TEST(Base, plain_number_is_the_whole_text)
    {
      EXPECT_EQ(plain_number(" 1.5e1 "), 15.);
      EXPECT_EQ(plain_number("+2"), 2.);
      EXPECT_EQ(plain_number("-2"), -2.);
      for (const char *const none : {"", "2*3", "1,5", "inf", "nan", "5 + y"})
        EXPECT_FALSE(plain_number(none).has_value()) << none;
    }
  } // namespace
} // namespace base_named_expression
