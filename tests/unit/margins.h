// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_tests_margins_h
#define waker_tests_margins_h

// How near do the comparisons of the unit tests come to their limits? CMake
// includes this header before all others with -DWAKER_TEST_MARGINS=ON. A run
// then writes the file that the environment variable WAKER_TEST_MARGINS names:
// of each EXPECT_NEAR, EXPECT_LT, EXPECT_LE (and ASSERT_...) the largest share
// of its limit that was met, the value, the limit, how often it was evaluated,
// and its place. Shares far below 0.1 are tolerances that would not see a test
// become ten times worse; what was evaluated 0 times is not in the list.

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <type_traits>

namespace Margins
{
  struct Margin
  {
    double        share = -1., value = 0., limit = 0.;
    unsigned long n = 0;
    std::string   expression;
  };


  /// Of all comparisons, by "file:line"; written at the end of the program.
  class Table
  {
  public:
    ~Table()
    {
      const char *const path = std::getenv("WAKER_TEST_MARGINS");
      if (path == nullptr)
        return;
      std::ofstream file(path);
      file << "share\tvalue\tlimit\tn\tplace\texpression\n";
      for (const auto &[place, m] : margins)
        file << m.share << '\t' << m.value << '\t' << m.limit << '\t' << m.n
             << '\t' << place << '\t' << m.expression << '\n';
    }

    void
    add(const char *const file,
        const int         line,
        const char *const expression,
        const double      value,
        const double      limit)
    {
      Margin      &m = margins[std::filesystem::path(file).filename().string() +
                          ":" + std::to_string(line)];
      const double share =
        limit == 0. ? (value == 0. ? 0. : HUGE_VAL) : std::abs(value / limit);
      ++m.n;
      if (share > m.share || std::isnan(share))
        m = {share, value, limit, m.n, expression};
    }

    static Table &
    of_this_run()
    {
      static Table table;
      return table;
    }

  private:
    std::map<std::string, Margin> margins;
  };


  /// Stands for GoogleTest's own comparisons.
  struct Place
  {
    const char *file;
    int         line;
    bool        or_equal = false;

    template <typename A, typename B>
    testing::AssertionResult
    operator()(const char *const text_a,
               const char *const text_b,
               const A          &a,
               const B          &b) const
    {
      if constexpr (std::is_floating_point_v<A> || std::is_floating_point_v<B>)
        Table::of_this_run().add(file, line, text_a, double(a), double(b));
      return or_equal ? testing::internal::CmpHelperLE(text_a, text_b, a, b)
                      : testing::internal::CmpHelperLT(text_a, text_b, a, b);
    }

    testing::AssertionResult
    operator()(const char *const text_a,
               const char *const text_b,
               const char *const text_c,
               const double      a,
               const double      b,
               const double      tolerance) const
    {
      Table::of_this_run().add(file, line, text_a, a - b, tolerance);
      return testing::internal::DoubleNearPredFormat(
        text_a, text_b, text_c, a, b, tolerance);
    }
  };


  inline Place
  here(const char *const file, const int line, const bool or_equal = false)
  {
    return {file, line, or_equal};
  }
} // namespace Margins

// clang-format off
#undef EXPECT_LT
#undef EXPECT_LE
#undef EXPECT_NEAR
#undef ASSERT_LT
#undef ASSERT_LE
#undef ASSERT_NEAR
#define EXPECT_LT(a, b) \
  EXPECT_PRED_FORMAT2(::Margins::here(__FILE__, __LINE__), a, b)
#define EXPECT_LE(a, b) \
  EXPECT_PRED_FORMAT2(::Margins::here(__FILE__, __LINE__, true), a, b)
#define EXPECT_NEAR(a, b, c) \
  EXPECT_PRED_FORMAT3(::Margins::here(__FILE__, __LINE__), a, b, c)
#define ASSERT_LT(a, b) \
  ASSERT_PRED_FORMAT2(::Margins::here(__FILE__, __LINE__), a, b)
#define ASSERT_LE(a, b) \
  ASSERT_PRED_FORMAT2(::Margins::here(__FILE__, __LINE__, true), a, b)
#define ASSERT_NEAR(a, b, c) \
  ASSERT_PRED_FORMAT3(::Margins::here(__FILE__, __LINE__), a, b, c)
// clang-format on

#endif
