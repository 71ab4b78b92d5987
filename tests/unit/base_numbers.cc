// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/numbers.h>
#include <waker/base/text.h>

#include <cmath>
#include <gtest/gtest.h>

namespace base_numbers
{
  using namespace Waker;


  TEST(Base, number_is_the_whole_text)
  {
    double number = 7.;
    for (const auto &[text, value] : {std::pair{"1", 1.},
                                      {"-2.5", -2.5},
                                      {"+3", 3.},
                                      {".5", .5},
                                      {"1e3", 1e3}})
      {
        EXPECT_TRUE(read_number(text, number)) << text;
        EXPECT_EQ(number, value);
      }
    number = 7.;
    for (const char *const text : {"",
                                   " ",
                                   "1 ",
                                   "0,5",
                                   "1;",
                                   "nan",
                                   "inf",
                                   "-inf",
                                   "1e400",
                                   "0x10",
                                   "+-1",
                                   "+",
                                   "1 m"})
      EXPECT_FALSE(read_number(text, number)) << text;
    EXPECT_EQ(number, 7.);
  }


  TEST(Base, numbers_of_messages_are_those_that_were_given)
  {
    EXPECT_EQ(in_digits(0.1), "0.1");
    EXPECT_EQ(in_digits(-250.), "-250");
    EXPECT_EQ(in_digits(1e-320), "1e-320");
    EXPECT_EQ(in_digits(1e300 * 1e300), "inf");
    EXPECT_NE(in_digits(std::nan("")).find("nan"), std::string::npos);
  }


  TEST(Base, titles_hold_no_number)
  {
    for (const char *const line : {"x, y, value",
                                   "level (m);P(h > level) (1/year)",
                                   "\"x\",\"y\"",
                                   "s_u2, c_10",
                                   "naam"})
      EXPECT_TRUE(may_be_titles(line)) << line;
    for (const char *const line : {"3,5;0,01",
                                   "3.5, 0.01",
                                   "\"3.5\",\"0.01\"",
                                   "level, 3",
                                   "-1;2",
                                   ".5",
                                   "x -.5",
                                   "3m, 0.1"})
      EXPECT_FALSE(may_be_titles(line)) << line;
  }


  TEST(Base, plain_text_is_utf_8)
  {
    for (const std::string text :
         {"", "D\xC3\xBCne", "\xE2\x82\xAC 5", "\xF0\x9F\x8C\x8A", "a\tb"})
      EXPECT_TRUE(is_plain_text(text)) << text;
    for (const std::string text : {"D\xFCne",          // Latin-1
                                   "\xE2\x82",         // cut off
                                   "\xC0\xAF",         // overlong
                                   "\xED\xA0\x80",     // surrogate
                                   "\xF4\x90\x80\x80", // beyond Unicode
                                   "\x80",
                                   "a\x01",
                                   "\x7f"})
      EXPECT_FALSE(is_plain_text(text));
    EXPECT_FALSE(is_plain_text(std::string(1, '\0')));
  }


  TEST(Base, values_in_messages_are_short_and_printable)
  {
    EXPECT_EQ(in_quotes("D\xC3\xBCne  1"), "\"D\xC3\xBCne 1\"");
    EXPECT_EQ(in_quotes("a\x01\xFC"), "\"a??\"");
    const std::string long_text(1000000, 'a');
    EXPECT_EQ(in_quotes(long_text), "\"" + std::string(60, 'a') + "...\"");
    // No half characters at the end.
    std::string umlauts;
    for (unsigned int i = 0; i < 100; ++i)
      umlauts += "\xC3\xBC";
    EXPECT_TRUE(is_plain_text(in_quotes("a" + umlauts)));
    EXPECT_EQ(without_byte_order_mark("\xEF\xBB\xBFx"), "x");
    EXPECT_EQ(without_byte_order_mark("x"), "x");
  }
} // namespace base_numbers
