// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/statistics/fragility.h>

#include "fragility_points.h"
#include "user_errors.h"
#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace statistics_yearly
{
  using namespace Waker;
  using namespace FragilityPoints;

  namespace
  {
    /// int P(h) f(h) dh by brute force: midpoints in the exceedance.
    double
    brute_force(const FragilityCurve &curve, const LevelDistribution &levels)
    {
      const unsigned int n   = 400000;
      double             sum = 0., lower = -10.;
      double             e = levels.exceedance(lower);
      sum                  = (1. - e) * curve(lower);
      for (unsigned int i = 1; i <= n; ++i)
        {
          const double upper = -10. + 30. * i / n;
          const double next  = levels.exceedance(upper);
          sum += curve(0.5 * (lower + upper)) * (e - next);
          lower = upper;
          e     = next;
        }
      return sum + e * curve(lower);
    }
  } // namespace


  TEST(Fragility, gumbel_and_table)
  {
    const LevelDistribution gumbel = LevelDistribution::gumbel(3., 0.25);
    EXPECT_NEAR(gumbel.exceedance(3.), 1. - std::exp(-1.), 1e-15);
    EXPECT_NEAR(gumbel.exceedance(3. + 0.25 * 20.) / std::exp(-20.), 1., 1e-8);

    const LevelDistribution table = LevelDistribution::parse_table(
      "level,probability\n# m, 1/year\n3,0.1\n\n3.5, 0.01\r\n4.5,1e-4\n",
      "t.csv");
    EXPECT_NEAR(table.exceedance(3.25), std::pow(10., -1.5), 1e-12);
    EXPECT_NEAR(table.exceedance(4.), 1e-3, 1e-12);
    EXPECT_NEAR(table.exceedance(5.), 1e-5, 1e-14);
    EXPECT_NEAR(table.exceedance(2.), 1., 1e-15);

    const std::array<const char *, 3> wrong[] = {
      {{"3,0.1\n", "t.csv", "has 1 lines"}},
      {{"3,0.1\n2.5,0.01\n", "t.csv:2", "does not continue"}},
      {{"3,0.1\n4,0.1\n", "t.csv:2", "does not continue"}},
      {{"3,0.1\n4,0\n", "t.csv:2", "out of range"}},
      {{"3,1.1\n4,0.1\n", "t.csv:1", "out of range"}},
      {{"3,0.1\n4 0.1\n", "t.csv:2", "\"4 0.1\" is not a level"}},
      {{"3,0.1\n4,0.01,7\n", "t.csv:2", "\"4,0.01,7\" is not a level"}},
      {{"h,p\n3,0.1\nx,y\n", "t.csv:3", "\"x,y\" is not a level"}},
      {{"3;0.1\n4,0.01\n5,0.001\n", "t.csv:1", "is not a level"}},
      {{"3,5;0,1\n4,0.01\n5,0.001\n", "t.csv:1", "is not a level"}},
      {{"3,5,0,1\n4,0.01\n5,0.001\n", "t.csv:1", "is not a level"}},
      {{"\"3\";\"0.1\"\n4,0.01\n5,0.001\n", "t.csv:1", "is not a level"}},
      {{"level,0.1\n4,0.01\n5,0.001\n", "t.csv:1", "is not a level"}}};
    for (const auto &line : wrong)
      EXPECT_USER_ERROR(LevelDistribution::parse_table(line[0], "t.csv"),
                        line[1],
                        line[2]);
    // The first row counts, whatever an editor puts before it.
    const LevelDistribution marked =
      LevelDistribution::parse_table("\xEF\xBB\xBF"
                                     "3,0.1\n4,0.01\n5,0.0001\n",
                                     "t.csv");
    EXPECT_NEAR(marked.exceedance(3.), 0.1, 1e-12);
    EXPECT_NEAR(LevelDistribution::parse_table(
                  "\xEF\xBB\xBFh;p\n3,0.1\n4,0.01\n", "t.csv")
                  .exceedance(3.),
                0.1,
                1e-12);
  }


  TEST(Fragility, yearly_probability_is_the_integral)
  {
    const std::vector<FragilityPoint> points = {point(3., 2, 1000),
                                                point(3.5, 5, 1000),
                                                point(4., 20, 1000),
                                                point(4.5, 60, 1000),
                                                point(4.75, 90, 1000)};
    const BoundedCurve                curve  = flooding_curve(points);
    const LevelDistribution           table =
      LevelDistribution::table({2.5, 3.2, 4.6, 5.}, {0.9, 0.2, 1e-3, 1e-5});
    for (const LevelDistribution &levels : {LevelDistribution::gumbel(3.6, 0.2),
                                            LevelDistribution::gumbel(2., 0.1),
                                            table})
      {
        const BoundedProbability p = yearly_probability(curve, levels);
        EXPECT_NEAR(p.estimate, brute_force(curve.estimate, levels), 1e-9);
        EXPECT_NEAR(p.low, brute_force(curve.low, levels), 1e-9);
        EXPECT_NEAR(p.high, brute_force(curve.high, levels), 1e-9);
        EXPECT_LT(p.low, p.estimate);
        EXPECT_GT(p.high, p.estimate);
      }

    // a level that is certain: nearly a step of the distribution
    EXPECT_NEAR(
      yearly_probability(curve, LevelDistribution::gumbel(4., 1e-4)).estimate,
      0.02,
      1e-4);
    // P(h) = h - 3 for 3 < h < 4 and E = exp(-(h - 3) / 0.1) by a table:
    // int E dh = 0.1 (1 - exp(-10))
    const FragilityCurve     line({3., 4.}, {0., 1.});
    const BoundedProbability exact =
      yearly_probability({line, line, line},
                         LevelDistribution::table({3., 4.},
                                                  {1., std::exp(-10.)}));
    EXPECT_NEAR(exact.estimate, 0.1 * (1. - std::exp(-10.)), 1e-12);
    // one level: constant
    const BoundedCurve single = flooding_curve({point(4., 20, 1000)});
    EXPECT_EQ(yearly_probability(single, table).estimate, 0.02);
  }
} // namespace statistics_yearly
