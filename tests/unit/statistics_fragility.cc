// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/statistics/fragility.h>
#include <waker/statistics/report_tables.h>
#include <waker/statistics/yearly.h>

#include "fragility_points.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <gtest/gtest.h>

namespace statistics_fragility
{
  using namespace Waker;
  using namespace FragilityPoints;


  TEST(Fragility, pool_adjacent_violators)
  {
    const std::vector<double> rising = {0., 0.1, 0.1, 0.4};
    EXPECT_EQ(make_rising(rising, {1, 1, 1, 1}), rising);

    const auto pooled =
      make_rising({0.1, 0.3, 0.2, 0.05, 0.5}, {1, 2, 1, 1, 1});
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
    // Slopes by hand: 3 d_0 = 0.03 at 3 m, where the parabola's is 0.07, 0 at
    // the peak, and the parabola's (3 d_1 - d_0) / 2 = -0.17 at 5 m.
    EXPECT_NEAR(peak(3.5), (0.1 + 0.11) / 2 + 0.03 / 8, 1e-15);
    EXPECT_NEAR(peak(4.5), 0.11 / 2 + 0.17 / 8, 1e-15);

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

    info.scenarios[1].water_level = NAN; // no water: no level
    EXPECT_EQ(fragility_points(info, records).size(), 1U);
    EXPECT_EQ(equal_levels_note(info), "");
    info.scenarios[1].water_level = 4.75; // something else is swept
    EXPECT_TRUE(fragility_points(info, records).empty());
    EXPECT_EQ(equal_levels_note(info), "");
    // Or the same level, written in two ways, by a version that took them.
    info.swept_parameter    = "Water/Level";
    info.scenarios[0].value = "4.75";
    info.scenarios[1].value = "4.750";
    EXPECT_EQ(equal_levels_note(info),
              "No fragility curve: Water/Level = 4.75 and 4.750 are the same "
              "level.");
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


  TEST(Fragility, bounds_are_no_estimates)
  {
    // As once reported: beta 0.960 at 3.5 m, of the upper bound of no flood in
    // 20, and 1.645 at 4.5 m, of one in 20: lower water looked more dangerous.
    const std::vector<FragilityPoint> points = {point(3., 0, 40),
                                                point(3.5, 0, 20),
                                                point(4.5, 1, 20),
                                                point(4.75, 20, 20)};
    const BoundedCurve                curve  = flooding_curve(points);
    std::vector<BoundedIndex>         beta;
    for (const FragilityPoint &p : points)
      beta.push_back(reliability_index(curve.at(p.water_level)));
    EXPECT_TRUE(std::isnan(beta[0].estimate));
    EXPECT_TRUE(std::isnan(beta[1].estimate));
    EXPECT_NEAR(beta[1].low, 0.960, 1e-3);
    EXPECT_NEAR(beta[2].estimate, 1.645, 1e-3);
    EXPECT_TRUE(std::isnan(beta[3].estimate));
    EXPECT_TRUE(std::isnan(beta[3].low));
    EXPECT_TRUE(std::isnan(beta[0].high));
    for (unsigned int i = 0; i + 1 < points.size(); ++i)
      if (std::isfinite(beta[i + 1].low))
        {
          EXPECT_GE(beta[i].low, beta[i + 1].low);
        }

    // only what is an estimate is exported as one; bounds at every level
    EXPECT_EQ(ReportTables::fragility_export(points),
              "hydraulicload,failure_probability\n4.5,0.05\n");
    const std::string upper = ReportTables::fragility_export_upper(points);
    EXPECT_EQ(std::count(upper.begin(), upper.end(), '\n'), 5);
    EXPECT_EQ(upper.find("nan"), std::string::npos);

    const std::string table = ReportTables::fragility_beta(points);
    EXPECT_NE(table.find("\n3.5,nan,0.96"), std::string::npos) << table;
    EXPECT_NE(table.find("nan,lower bound\n4.5,1.64"), std::string::npos)
      << table;
    EXPECT_NE(table.find(",upper bound\n"), std::string::npos) << table;
    for (const std::string &text : {table,
                                    ReportTables::fragility(points),
                                    ReportTables::fragility_curve(points)})
      EXPECT_EQ(text.find("inf"), std::string::npos) << text;
  }


  TEST(Fragility, bounds_hold_whatever_the_undecided_would_have_done)
  {
    // 3 of 15 flooded and 15 still moving at 4 m, nothing undecided at 3 m, all
    // undecided at 4.5 m
    CampaignInfo info;
    info.swept_parameter = "Water/Level";
    info.scenarios.resize(3);
    std::vector<std::vector<Record>> records(3);
    for (unsigned int s = 0; s < 3; ++s)
      {
        info.scenarios[s].water_level = s == 2 ? 4.5 : 3. + s;
        info.scenarios[s].value       = s == 2 ? "4.5" : s == 1 ? "4" : "3";
        info.scenarios[s].crest_level = 5.;
        records[s].resize(30);
        for (unsigned int i = 0; i < 30; ++i)
          {
            Record &record = records[s][i];
            if (s == 2 || (s == 1 && i >= 15))
              record.outcome = Outcome::still_moving;
            else if (s == 1 && i < 3)
              {
                record.outcome      = Outcome::flooding;
                record.initial_time = record.flooding_time = 3.;
              }
          }
      }
    const auto points = fragility_points(info, records);
    ASSERT_EQ(points.size(), 3U);
    EXPECT_EQ(points[1].flooding.n, 15U);
    EXPECT_EQ(points[1].n_lost, 15U);

    const BoundedCurve curve = flooding_curve(points);
    EXPECT_EQ(curve.at(points[1]).estimate, 0.2);
    EXPECT_NEAR(curve.at(points[1]).high, proportion(18, 30).high, 1e-15);
    EXPECT_NEAR(curve.at(points[1]).low, proportion(3, 30).low, 1e-15);
    EXPECT_NEAR(curve.at(points[0]).high, proportion(0, 30).high, 1e-15);
    EXPECT_TRUE(std::isnan(curve.at(points[2]).estimate));
    EXPECT_EQ(curve.at(points[2]).high, 1.);
    EXPECT_EQ(curve.at(points[2]).low, curve.at(points[1]).low);
    // It spoils no bound of a level that is known, nor does one below.
    std::vector<FragilityPoint> lowest = {points[2], points[1]};
    lowest[0].water_level              = 3.;
    EXPECT_EQ(flooding_curve(lowest).at(lowest[1]).high,
              curve.at(points[1]).high);
    EXPECT_EQ(flooding_curve(lowest).at(lowest[0]).high,
              curve.at(points[1]).high);

    const std::string upper = ReportTables::fragility_export_upper(points);
    char              line[60];
    std::snprintf(line,
                  sizeof line,
                  "\n4,%.12g\n4.5,1\n",
                  proportion(18, 30).high);
    EXPECT_NE(upper.find(line), std::string::npos) << upper;
    EXPECT_EQ(ReportTables::fragility_export(points),
              "hydraulicload,failure_probability\n4,0.2\n");

    // always about 4 m: the budget is met by those that are decided alone, and
    // by all of them it cannot be told
    RiskParameters parameters;
    parameters.allowed_probability = 1.;
    parameters.share               = 0.55;
    parameters.consequence         = 1e6;
    std::vector<std::string> notes;
    const LevelDistribution  about_4 = LevelDistribution::gumbel(4., 1e-4);
    const auto now = yearly(true, points, about_4, parameters, notes);
    EXPECT_NEAR(now->flooding.estimate, 0.2, 1e-3);
    EXPECT_NEAR(now->flooding.high, proportion(18, 30).high, 1e-3);
    EXPECT_EQ(now->risk.macro_instability->verdict, Verdict::undecided);
    EXPECT_NEAR(now->risk.risk->high, 1e6 * now->flooding.high, 1e-3);
    EXPECT_EQ(now->undecided, "45 of 90 undecided");
    std::vector<FragilityPoint> decided = points;
    decided.pop_back();
    for (FragilityPoint &p : decided)
      p.flooding_bounds.reset();
    EXPECT_EQ(yearly(true, decided, about_4, parameters, notes)
                ->risk.macro_instability->verdict,
              Verdict::met);

    const auto said = undecided_notes(info, records);
    ASSERT_EQ(said.size(), 1U);
    EXPECT_EQ(
      said[0].find(
        "45 of 90 undecided: 45 still moving (Water/Level = 4: 15 of 30 "
        "undecided; 4.5: 30 of 30 undecided)."),
      0U)
      << said[0];
    records.resize(1);
    info.scenarios.resize(1);
    EXPECT_TRUE(undecided_notes(info, records).empty());

    // nothing decided anywhere
    const BoundedCurve none = flooding_curve({points[2]});
    EXPECT_TRUE(std::isnan(yearly_probability(none, about_4).estimate));
    EXPECT_EQ(yearly_probability(none, about_4).high, 1.);
  }


  TEST(Fragility, bounds_made_to_rise_still_are_bounds)
  {
    // pooled: the upper bound is not below the lower one of the two, the lower
    // bound not above the higher one
    const std::vector<FragilityPoint> points = {point(3., 8, 100),
                                                point(4., 4, 300)};
    const BoundedCurve                curve  = flooding_curve(points);
    for (const FragilityPoint &p : points)
      {
        const BoundedProbability at = curve.at(p.water_level);
        EXPECT_NEAR(at.estimate, 12. / 400., 1e-15);
        EXPECT_GE(at.high,
                  std::min(points[0].flooding.high, points[1].flooding.high));
        EXPECT_LE(at.low,
                  std::max(points[0].flooding.low, points[1].flooding.low));
      }
  }


  TEST(Fragility, notes_say_where_it_falls)
  {
    const auto notes_of = [](const std::vector<FragilityPoint> &points) {
      std::string text;
      for (const std::string &note : fragility_notes(points))
        text += note + "\n";
      return text;
    };
    // initial failure 10 more than flooding
    const std::string none =
      notes_of({point(3., 1, 100), point(4., 4, 100), point(4.75, 30, 100)});
    EXPECT_EQ(none, "");

    const std::string chance = notes_of({point(3., 4, 100), point(4., 1, 100)});
    EXPECT_NE(chance.find("P(F|h) falls with rising water, 4 of 100 at 3 m and "
                          "1 of 100 at 4 m, as chance"),
              std::string::npos)
      << chance;
    EXPECT_NE(chance.find("P(S1|h) falls"), std::string::npos) << chance;

    std::vector<FragilityPoint> outer = {point(3., 0, 100), point(4., 1, 100)};
    outer[0].initial                  = proportion(54, 100);
    const std::string text            = notes_of(outer);
    EXPECT_NE(text.find(
                "54 of 100 at 3 m and 11 of 100 at 4 m, more than chance"),
              std::string::npos)
      << text;
    EXPECT_EQ(text.find("P(F|h) falls"), std::string::npos) << text;
    EXPECT_NE(text.find("Flooded: 0 of 100 at 3 m"), std::string::npos) << text;

    const std::string strange =
      notes_of({point(3., 80, 100), point(4., 4, 100)});
    EXPECT_NE(strange.find("Higher water is not safer"), std::string::npos)
      << strange;
  }


  TEST(Fragility, levels_are_above_any_datum)
  {
    // 20 m lower: the same curves and the same years
    const std::vector<FragilityPoint> points = {point(3., 0, 100),
                                                point(4., 4, 100),
                                                point(4.75, 30, 100)};
    std::vector<FragilityPoint>       low    = points;
    for (FragilityPoint &p : low)
      p.water_level -= 20.;
    RiskParameters parameters;
    parameters.allowed_probability = 0.01;
    std::vector<std::string> notes;
    const LevelDistribution  above = LevelDistribution::gumbel(3.5, 0.25),
                            below  = LevelDistribution::gumbel(-16.5, 0.25);
    const auto a = yearly(true, points, above, parameters, notes);
    const auto b = yearly(true, low, below, parameters, notes);
    EXPECT_NEAR(a->flooding.estimate, b->flooding.estimate, 1e-12);
    EXPECT_NEAR(a->flooding.high, b->flooding.high, 1e-12);
    EXPECT_NEAR(a->initial.low, b->initial.low, 1e-12);
    EXPECT_NEAR(a->above_the_crest, b->above_the_crest, 1e-12);
    EXPECT_NEAR(a->share_from_above, b->share_from_above, 1e-12);
    EXPECT_NEAR(a->above_the_crest, above.exceedance(5.), 1e-15);
    const LevelDistribution table =
      LevelDistribution::parse_table("-18,0.1\n-16,0.001\n", "t.csv");
    EXPECT_NEAR(table.exceedance(-17.), 0.01, 1e-12);
  }
} // namespace statistics_fragility
