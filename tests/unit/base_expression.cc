// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/expression.h>
#include <waker/base/expression_scan.h>
#include <waker/base/time_function.h>

#include <cmath>
#include <gtest/gtest.h>

namespace base_expression
{
  // An expression is a formula of the place and the time, and nothing else.

  using namespace Waker;

  namespace
  {
    double
    at(const std::string &text, const Point<2> &x, const double t)
    {
      return Expression<2>(text, "A/B").value(x, t);
    }


    /// The error for a text that must be refused.
    UserError
    complaint(const std::string &text)
    {
      try
        {
          const Expression<2> expression(text, "A/B", ", or \"free\"");
          ADD_FAILURE() << text << " is accepted: "
                        << expression.value(Point<2>(1., 2.), 3.);
        }
      catch (const UserError &error)
        {
          EXPECT_EQ(error.where, "A/B");
          return error;
        }
      return {"", "", ""};
    }


    void
    expect_complaint(const std::string &text, const std::string &words)
    {
      const UserError error = complaint(text);
      EXPECT_NE(error.problem.find(words), std::string::npos) << error.what();
      EXPECT_NE(error.allowed.find("x, y, t, or \"free\""), std::string::npos)
        << error.allowed;
    }
  } // namespace


  TEST(Base, expression_is_a_formula)
  {
    const Point<2> x(2., -3.);
    EXPECT_DOUBLE_EQ(at("5 + 1.5*(5 - y)", x, 0.), 17.);
    EXPECT_DOUBLE_EQ(at("max(x, 0.25)", x, 0.), 2.);
    EXPECT_DOUBLE_EQ(at("max (x, 0.25) + min( 1, 2 ,3 )", x, 0.), 3.);
    EXPECT_DOUBLE_EQ(at("atan2(y,x)", x, 0.), std::atan2(-3., 2.));
    EXPECT_DOUBLE_EQ(at("t>=2 && x!=1 ? .5e1 : 2e-1", x, 2.), 5.);
    EXPECT_DOUBLE_EQ(at("if(t == 3, x^2, 0)", x, 3.), 4.);
    EXPECT_DOUBLE_EQ(at("pi", x, 0.), std::acos(-1.));
    EXPECT_TRUE(Expression<2>("exp(2)", "").is_uniform());
    EXPECT_FALSE(Expression<2>("exp(2)", "").moves()); // no t in it
    EXPECT_TRUE(Expression<2>("sin(t)", "").moves());
    EXPECT_FALSE(Expression<3>("z", "").is_uniform());
  }


  TEST(Base, expression_has_all_functions_that_it_names)
  {
    for (const std::string &function : expression_functions)
      {
        const unsigned int n    = function == "if"                           ? 3
                                  : function == "atan2" || function == "pow" ? 2
                                                                             : 1;
        std::string        text = function + "(0.5";
        for (unsigned int i = 1; i < n; ++i)
          text += ", 0.5";
        // acosh(0.5) is no number, as it should.
        if (function == "acosh")
          text = "acosh(2";
        EXPECT_TRUE(std::isfinite(at(text + ")", Point<2>(), 0.))) << text;
      }
  }


  TEST(Base, expression_refuses_a_decimal_comma)
  {
    // muParser takes what follows the last comma.
    for (const std::string text : {"0,25",
                                   "12,5",
                                   "-1,5",
                                   "x, y",
                                   "(1,5)",
                                   "sin(x) + 0,5*t",
                                   "max(x, (1,5))",
                                   ","})
      {
        expect_complaint(text, "comma");
        EXPECT_NE(complaint(text).allowed.find("decimals with a point"),
                  std::string::npos);
      }
    expect_complaint("sin(0,5)", "too many arguments");
  }


  TEST(Base, expression_refuses_what_is_no_formula)
  {
    expect_complaint("", "empty");
    expect_complaint("  ", "empty");
    expect_complaint("1; 2", "\";\"");
    expect_complaint("3 +", "ends too early");
    expect_complaint("* 3", "value is missing");
    expect_complaint("2 3", "no operator");
    expect_complaint("2x", "no operator");
    expect_complaint("1.2.3", "no operator");
    expect_complaint("(1", "not closed");
    expect_complaint("1)", "not open");
    expect_complaint("atan2(1)", "too few arguments");
    expect_complaint("sine(x)", "no function \"sine\"");
    expect_complaint("sin", "parentheses");
    expect_complaint("z", "\"z\" is unknown");
    expect_complaint("nan", "\"nan\" is unknown");
    expect_complaint("_pi", "unknown"); // muParser's has twelve digits
    expect_complaint("x = 3", "change a value");
    expect_complaint("t ? 1", "\"?\"");
    expect_complaint("1e400", "beyond the range");
    expect_complaint("'a'", "no meaning");
    expect_complaint("\xfc", "\"?\" has no meaning");
    const std::string sum(40000, '1');
    expect_complaint(sum, "40000 characters");
    EXPECT_LT(complaint(sum).problem.size(), 200u); // long values are cut
    std::string deep(1900, '(');
    deep += "1" + std::string(1900, ')');
    EXPECT_EQ(at(deep, Point<2>(), 0.), 1.);
  }


  TEST(Base, expression_that_does_not_repeat_is_refused)
  {
    expect_complaint("rand()", "would not repeat");
    expect_complaint("10 + rand_seed(3)", "would not repeat");
    expect_complaint("10*rand ()", "would not repeat");
  }


  TEST(Base, expression_that_is_a_number_is_finite)
  {
    for (const std::string text : {"1/0", "log(0)", "sqrt(-1)", "1e308*10"})
      {
        const UserError error = complaint(text);
        EXPECT_EQ(error.allowed, "finite numbers") << text;
      }
    EXPECT_THROW(TimeFunction("0/0", ""), UserError);
    // This depends on the place: who asks must look.
    EXPECT_FALSE(std::isfinite(at("1/x", Point<2>(), 0.)));
  }


  TEST(Base, expression_errors_can_be_caught_as_std_exceptions)
  {
    for (const std::string text : {"1; 2", "", "sin(", "1 1", "\"a", "x ? y"})
      EXPECT_THROW(Expression<2>(text, ""), std::exception) << text;
  }
} // namespace base_expression
