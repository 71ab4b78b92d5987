// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/statistics/risk.h>

#include "user_errors.h"
#include <gtest/gtest.h>

namespace statistics_risk
{
  using namespace Waker;

  TEST(Risk, point_statistics_of_the_thesis)
  {
    // section 5.4.1: FoS 1.3, COV 0.2; the thesis prints 0.13
    EXPECT_NEAR(failure_by_point_statistics(1.3, 0.2), 0.1243, 5e-5);
    // P(N(13, 0.2 * 13) < 10)
    EXPECT_NEAR(failure_by_point_statistics(1.3, 0.2),
                normal_distribution((10. - 13.) / (0.2 * 13.)),
                1e-15);
    EXPECT_NEAR(failure_by_point_statistics(1., 0.1), 0.5, 1e-15);
  }


  TEST(Risk, budgets_and_verdicts)
  {
    RiskParameters parameters;
    parameters.allowed_probability = 1e-2;
    parameters.consequence         = 1e9;

    const Risk risk = assess_risk({1e-3, 5e-4, 2e-3}, parameters);
    EXPECT_NEAR(risk.all_mechanisms->budget, 0.7e-2, 1e-15);
    EXPECT_EQ(risk.all_mechanisms->verdict, Verdict::met);
    EXPECT_NEAR(risk.macro_instability->budget, 4e-4, 1e-15);
    EXPECT_EQ(risk.macro_instability->verdict, Verdict::not_met);
    EXPECT_NEAR(risk.risk->estimate, 1e6, 1e-6);
    EXPECT_NEAR(risk.risk->low, 5e5, 1e-6);
    EXPECT_NEAR(risk.risk->high, 2e6, 1e-6);
    EXPECT_EQ(risk.risk->kind, EstimateKind::estimate);
    // a euro for certain is a bound as much as a probability of 1 is
    parameters.consequence = 1.;
    EXPECT_EQ(assess_risk({1., 0.9, 1.}, parameters).risk->kind,
              EstimateKind::lower_bound);
    EXPECT_EQ(assess_risk({0., 0., 0.1}, parameters).risk->kind,
              EstimateKind::upper_bound);

    EXPECT_EQ(compare({1e-3, 5e-4, 2e-3}, 1.5e-3), Verdict::undecided);
    EXPECT_EQ(compare({1e-3, 5e-4, 2e-3}, 6e-4), Verdict::undecided);
    EXPECT_EQ(compare({0., 0., 1.}, 1.), Verdict::met);
    // A lower bound at the budget is not above it.
    EXPECT_EQ(compare({1e-3, 5e-4, 2e-3}, 5e-4), Verdict::undecided);

    const Risk unknown = assess_risk({1e-3, 5e-4, 2e-3}, RiskParameters());
    EXPECT_FALSE(unknown.all_mechanisms || unknown.macro_instability ||
                 unknown.risk);
  }


  TEST(Risk, parameters_are_checked)
  {
    AnalysisParameters parameters;
    parameters.check();

    AnalysisParameters wrong = parameters;
    wrong.risk.distribution  = LevelSource::gumbel;
    EXPECT_USER_ERROR(wrong.check(), "Risk/Gumbel scale", "is 0");
    wrong.risk.scale = 0.2;
    wrong.check();

    wrong                   = parameters;
    wrong.risk.distribution = LevelSource::table;
    EXPECT_USER_ERROR(wrong.check(), "Risk/Level table", "is empty");

    wrong                       = parameters;
    wrong.risk.factor_of_safety = 1.3;
    EXPECT_USER_ERROR(wrong.check(), "Risk/Strength variation", "is 0");

    wrong                      = parameters;
    wrong.histograms.width_bin = 0.;
    EXPECT_USER_ERROR(wrong.check(), "Histograms/Width bin", "is 0");
  }
} // namespace statistics_risk
