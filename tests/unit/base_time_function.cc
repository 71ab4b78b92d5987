// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/time_function.h>

#include <gtest/gtest.h>

namespace base_time_function
{
  using namespace Waker;

  namespace
  {
    double
    at(const std::string &text, const double t)
    {
      return TimeFunction(text, "Section/Name").value(t);
    }


    std::string
    complaint(const std::string &text)
    {
      try
        {
          TimeFunction(text, "Section/Name");
        }
      catch (const UserError &error)
        {
          EXPECT_EQ(error.where, "Section/Name");
          return error.problem;
        }
      return "";
    }
  } // namespace


  TEST(Base, time_function_of_a_number_or_an_expression)
  {
    EXPECT_EQ(TimeFunction(3.5).value(7.), 3.5);
    EXPECT_FALSE(TimeFunction(3.5).moves());
    EXPECT_EQ(at(" -2.25 ", 100.), -2.25);
    EXPECT_FALSE(TimeFunction("1 + 2*pi", "").moves());
    EXPECT_DOUBLE_EQ(at("4 + 0.5*t", 3.), 5.5);
    EXPECT_TRUE(TimeFunction("4 + 0.5*t", "").moves());
    // The colon of muParser's choice is no table's.
    EXPECT_EQ(at("t < 2 ? 1 : 5", 1.), 1.);
    EXPECT_EQ(at("t < 2 ? 1 : 5", 3.), 5.);
    // Copies live on their own.
    TimeFunction copy;
    {
      const TimeFunction original("2*t", "");
      copy = original;
    }
    EXPECT_EQ(copy.value(4.), 8.);
  }


  TEST(Base, time_function_of_a_table)
  {
    const std::string table = "1: 4, 3: 5,5.5:-1e1";
    EXPECT_TRUE(TimeFunction(table, "").moves());
    EXPECT_EQ(at(table, -7.), 4.);
    EXPECT_EQ(at(table, 1.), 4.);
    EXPECT_DOUBLE_EQ(at(table, 2.5), 4.75);
    EXPECT_EQ(at(table, 3.), 5.);
    EXPECT_DOUBLE_EQ(at(table, 4.25), -2.5);
    EXPECT_EQ(at(table, 5.5), -10.);
    EXPECT_EQ(at(table, 99.), -10.);
    EXPECT_EQ(at("2: 7", 0.), 7.);
    EXPECT_FALSE(TimeFunction("2: 7", "").moves());
  }


  TEST(Base, time_function_knows_when_it_changes_last)
  {
    EXPECT_EQ(TimeFunction(3.5).last_change(), LastChange::never);
    EXPECT_EQ(TimeFunction("2: 7", "").last_change(), LastChange::never);
    EXPECT_EQ(TimeFunction("0: 7, 5: 7", "").last_change(), LastChange::never);
    EXPECT_EQ(TimeFunction("0: 0, 5: 0, 10: 2", "").last_change(), 10.);
    EXPECT_EQ(TimeFunction("0: 0, 5: 1, 10: 1, 11: 1", "").last_change(), 5.);
    EXPECT_EQ(TimeFunction("min(t, 5)", "").last_change(), LastChange::unknown);

    const TimeFunction table("0: 0, 5: 0, 6: 2, 7: 0, 9: 0", "");
    EXPECT_FALSE(table.varies(0., 5.));
    EXPECT_TRUE(table.varies(0., 5.5));
    EXPECT_TRUE(table.varies(4., 8.)); // a peak between equal ends
    EXPECT_FALSE(table.varies(7., 99.));

    const TimeFunction ramp("min(t, 5)", "");
    EXPECT_TRUE(ramp.varies(4.9, 20.));
    EXPECT_FALSE(ramp.varies(5., 20.));
    EXPECT_FALSE(TimeFunction("2*(1 - exp(-t))", "").varies(20., 40.));
    EXPECT_TRUE(TimeFunction("t < 7 ? 1 : 1/0", "").varies(5., 8.));
    EXPECT_TRUE(TimeFunction("0.001*t", "").varies(39., 40.));
  }


  TEST(Base, time_function_refuses_what_it_cannot_read)
  {
    EXPECT_NE(complaint("").find("empty"), std::string::npos);
    EXPECT_NE(complaint("3 +").find("cannot be read"), std::string::npos);
    EXPECT_NE(complaint("3 + x").find("place"), std::string::npos);
    EXPECT_NE(complaint("1/t").find("not finite"), std::string::npos);
    EXPECT_NE(complaint("0: 1, 2: 3, 2: 4").find("does not come after"),
              std::string::npos);
    EXPECT_NE(complaint("0: 1, -2: 3").find("does not come after"),
              std::string::npos);
    EXPECT_NE(complaint("0: 1, 3").find("no pair"), std::string::npos);
    EXPECT_NE(complaint("0: 1, 3: 2: 1").find("no pair"), std::string::npos);
    EXPECT_NE(complaint("0: 1, 3: high").find("no number"), std::string::npos);
    EXPECT_NE(complaint("0: 1,").find("no pair"), std::string::npos);
  }
} // namespace base_time_function
