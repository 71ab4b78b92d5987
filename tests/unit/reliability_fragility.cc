// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/reliability/fragility.h>

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace
{
  using namespace Waker;

  FragilityPoint
  point(const double level, const std::uint64_t count, const std::uint64_t n)
  {
    return {level, 5. - level, proportion(count + 10, n), proportion(count, n)};
  }


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


TEST(Fragility, pool_adjacent_violators)
{
  const std::vector<double> rising = {0., 0.1, 0.1, 0.4};
  EXPECT_EQ(make_rising(rising, {1, 1, 1, 1}), rising);

  const auto pooled = make_rising({0.1, 0.3, 0.2, 0.05, 0.5}, {1, 2, 1, 1, 1});
  // 0.3, 0.2 and 0.05 become their weighted mean
  EXPECT_NEAR(pooled[0], 0.1, 1e-15);
  for (const unsigned int i : {1, 2, 3})
    EXPECT_NEAR(pooled[i], (2 * 0.3 + 0.2 + 0.05) / 4, 1e-15);
  EXPECT_EQ(pooled[4], 0.5);

  const auto falling = make_rising({3, 2, 1}, {1, 1, 4});
  for (const double value : falling)
    EXPECT_NEAR(value, 1.5, 1e-15);
}


TEST(Fragility, curve_passes_its_points_and_never_leaves_them)
{
  const std::vector<double> levels = {3., 3.5, 4., 4.5, 4.75};
  const std::vector<double> values = {0.12, 0.05, 0.05, 0.08, 0.4};
  const FragilityCurve      curve(levels, values);
  for (unsigned int i = 0; i < 5; ++i)
    EXPECT_NEAR(curve(levels[i]), values[i], 1e-15);
  EXPECT_EQ(curve(-5.), 0.12);
  EXPECT_EQ(curve(9.), 0.4);
  EXPECT_EQ(curve.slope(9.), 0.);
  for (unsigned int i = 0; i + 1 < 5; ++i)
    for (double t = 0.05; t < 1.; t += 0.05)
      {
        const double h = levels[i] + t * (levels[i + 1] - levels[i]);
        EXPECT_GE(curve(h), std::min(values[i], values[i + 1]) - 1e-15);
        EXPECT_LE(curve(h), std::max(values[i], values[i + 1]) + 1e-15);
        EXPECT_NEAR(curve.slope(h),
                    (curve(h + 1e-6) - curve(h - 1e-6)) / 2e-6,
                    1e-8);
      }
  // scipy.interpolate.PchipInterpolator
  const std::vector<std::array<double, 2>> reference = {
    {{3.1, 0.09928}},
    {{3.4, 0.05392}},
    {{4.2, 0.0544386715867}},
    {{4.6, 0.15675099631}},
    {{4.7, 0.313766888069}}};
  for (const auto &pair : reference)
    EXPECT_NEAR(curve(pair[0]), pair[1], 1e-11);
  // and a smooth function is followed closely
  std::vector<double> smooth_levels, smooth_values;
  for (double h = 3.; h < 4.8; h += 0.2)
    {
      smooth_levels.push_back(h);
      smooth_values.push_back(normal_distribution(h - 5.));
    }
  const FragilityCurve smooth(smooth_levels, smooth_values);
  for (double h = 3.; h < 4.6; h += 0.03)
    EXPECT_NEAR(smooth(h), normal_distribution(h - 5.), 3e-4);

  // a parabola through the first three points would fall at first
  const FragilityCurve steep({3., 4., 5.}, {0.001, 0.01, 0.3});
  const FragilityCurve flat({3., 4., 5.}, {0., 0.29, 0.299});
  for (double h = 3.; h < 5.; h += 0.05)
    {
      EXPECT_GE(steep.slope(h), 0.);
      EXPECT_GE(flat.slope(h), 0.);
    }

  // and rise beyond the second
  const FragilityCurve peak({3., 4., 5.}, {0.1, 0.11, 0.});
  for (double h = 3.; h < 5.; h += 0.05)
    EXPECT_LE(peak(h), 0.11 + 1e-15);

  const FragilityCurve line({1., 2.}, {0.1, 0.3});
  EXPECT_NEAR(line(1.25), 0.15, 1e-15);
  EXPECT_EQ(FragilityCurve({1.}, {0.2})(3.), 0.2);
}


TEST(Fragility, points_are_by_level_and_of_levels_only)
{
  CampaignInfo info;
  info.scenarios.resize(3);
  info.scenarios[0].water_level = 4.75;
  info.scenarios[1].water_level = 4.;
  info.scenarios[2].water_level = 4.5; // not run yet
  for (ScenarioInfo &scenario : info.scenarios)
    scenario.crest_level = 5.;
  std::vector<std::vector<Record>> records(3);
  records[0].resize(4);
  records[0][2].initial_time = 3.;
  records[1].resize(2);
  const auto points = fragility_points(info, records);
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0].water_level, 4.);
  EXPECT_EQ(points[0].freeboard, 1.);
  EXPECT_EQ(points[1].initial.estimate, 0.25);

  info.scenarios[1].water_level = 4.75; // something else is swept
  EXPECT_TRUE(fragility_points(info, records).empty());
}


TEST(Fragility, flooding_rises_with_the_level_and_initial_failure_need_not)
{
  const std::vector<FragilityPoint> points   = {point(3., 8, 100),
                                                point(4., 4, 100),
                                                point(4.75, 30, 100)};
  const BoundedCurve                flooding = flooding_curve(points);
  EXPECT_NEAR(flooding.estimate.values[0], 0.06, 1e-15);
  EXPECT_NEAR(flooding.estimate.values[1], 0.06, 1e-15);
  EXPECT_EQ(flooding.estimate.values[2], 0.3);
  const BoundedCurve initial = initial_failure_curve(points);
  EXPECT_EQ(initial.estimate.values[0], 0.18);
  EXPECT_EQ(initial.estimate.values[1], 0.14);
  for (double h = 2.9; h < 5.; h += 0.01)
    {
      const BoundedProbability p = flooding.at(h);
      EXPECT_LE(p.low, p.estimate);
      EXPECT_GE(p.high, p.estimate);
      EXPECT_LE(flooding.estimate(h), flooding.estimate(h + 0.01) + 1e-15);
    }
}


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

  for (const char *const wrong : {"3,0.1\n",
                                  "3,0.1\n2.5,0.01\n",
                                  "3,0.1\n4,0.1\n",
                                  "3,0.1\n4,0\n",
                                  "3,1.1\n4,0.1\n",
                                  "3,0.1\n4 0.1\n",
                                  "3,0.1\n4,0.01,7\n"})
    EXPECT_THROW(LevelDistribution::parse_table(wrong, "t.csv"), UserError)
      << wrong;
  try
    {
      LevelDistribution::parse_table("h,p\n3,0.1\nx,y\n", "t.csv");
      FAIL();
    }
  catch (const UserError &error)
    {
      EXPECT_EQ(error.where, "t.csv:3");
    }
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
