// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/statistics/estimates.h>
#include <waker/statistics/histograms.h>

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace statistics_estimates
{
  namespace
  {
    using namespace Waker;

    Record
    make_record(const std::uint64_t realisation,
                const double        initial  = -1.,
                const double        flooding = -1.)
    {
      Record record;
      record.realisation         = realisation;
      record.initial_time        = initial;
      record.initial_time_thesis = initial;
      record.flooding_time       = flooding;
      record.end_time            = 10.;
      record.outcome             = flooding >= 0.  ? Outcome::flooding
                                   : initial >= 0. ? Outcome::initial_failure
                                                   : Outcome::stable;
      return record;
    }


    /// 1000 realisations with about 12 % initial failures, of which 3/4 flood.
    std::vector<Record>
    campaign()
    {
      std::mt19937                           generator(3);
      std::uniform_real_distribution<double> uniform(0., 1.);
      std::vector<Record>                    records;
      for (std::uint64_t i = 0; i < 1000; ++i)
        {
          const double initial =
            uniform(generator) < 0.12 ? 2. + 3. * uniform(generator) : -1.;
          const double flooding = initial > 0. && uniform(generator) < 0.75
                                    ? initial + 4. * uniform(generator)
                                    : -1.;
          records.push_back(make_record(i, initial, flooding));
        }
      return records;
    }
  } // namespace


  TEST(Estimates, the_undecided_are_counted_excluded_and_bound)
  {
    std::vector<Record> records;
    for (std::uint64_t i = 0; i < 12; ++i)
      records.push_back(make_record(i));
    records[0]         = make_record(0, 2., 5.);
    records[1]         = make_record(1, 2.5);
    records[1].unrest  = {true, false, false}; // may flood yet
    records[2]         = make_record(2, 2.5);
    records[2].unrest  = Unrest();            // will not
    records[3]         = make_record(3, 2.5); // nobody says
    records[4].outcome = Outcome::still_moving;
    records[5].outcome = Outcome::loads_change;
    records[6].outcome = Outcome::loads_change;
    records[7].outcome = Outcome::stopped_by_box;

    const ScenarioEstimate e = estimate(records);
    EXPECT_EQ(e.n, 8U);
    EXPECT_EQ(e.n_numerical, 0U);
    EXPECT_EQ(e.n_still_moving, 1U);
    EXPECT_EQ(e.n_loads_change, 2U);
    EXPECT_EQ(e.n_stopped_by_box, 1U);
    EXPECT_EQ(e.n_undecided(), 4U);
    EXPECT_EQ(e.n_not_final, 1U);
    EXPECT_DOUBLE_EQ(e.by_geometry.initial.estimate, 4. / 8.);
    EXPECT_DOUBLE_EQ(e.by_geometry.flooding.estimate, 1. / 8.);
    EXPECT_DOUBLE_EQ(e.if_all_failed.initial.estimate, 8. / 12.);
    EXPECT_DOUBLE_EQ(e.if_all_failed.flooding.estimate, 6. / 12.);
    EXPECT_DOUBLE_EQ(e.if_none_failed.initial.estimate, 4. / 12.);
    EXPECT_DOUBLE_EQ(e.if_none_failed.flooding.estimate, 1. / 12.);
    EXPECT_EQ(estimate_convergence(records).back().position, 8.);
  }


  TEST(Estimates, numerical_failures_are_counted_and_excluded)
  {
    std::vector<Record> records;
    for (std::uint64_t i = 0; i < 10; ++i)
      records.push_back(make_record(i));
    records[3]                     = make_record(3, 2., 5.);
    records[4]                     = make_record(4, 2.5);
    records[4].initial_time_thesis = -1.; // slid outwards
    records[7]                     = make_record(7, 3.);
    records[7].outcome             = Outcome::numerical_failure;
    records[8].outcome             = Outcome::numerical_failure;

    const ScenarioEstimate e = estimate(records);
    EXPECT_EQ(e.n, 8U);
    EXPECT_EQ(e.n_numerical, 2U);
    EXPECT_EQ(e.by_geometry.initial.count, 2U);
    EXPECT_DOUBLE_EQ(e.by_geometry.initial.estimate, 0.25);
    EXPECT_DOUBLE_EQ(e.by_geometry.flooding.estimate, 0.125);
    EXPECT_DOUBLE_EQ(e.by_geometry.flooding_given.estimate, 0.5);
    EXPECT_EQ(e.by_geometry.flooding_given.n, 2U);
    EXPECT_DOUBLE_EQ(e.by_width.initial.estimate, 0.125);
    EXPECT_DOUBLE_EQ(e.by_width.flooding_given.estimate, 1.);
    EXPECT_DOUBLE_EQ(e.if_all_failed.initial.estimate, 0.4);
    EXPECT_DOUBLE_EQ(e.if_all_failed.flooding.estimate, 0.3);
    // The seventh had slid before it failed numerically: in both bounds.
    EXPECT_DOUBLE_EQ(e.if_none_failed.initial.estimate, 0.3);
    EXPECT_DOUBLE_EQ(e.if_none_failed.flooding.estimate, 0.1);

    EXPECT_TRUE(std::isnan(estimate({}).by_geometry.initial.estimate));
    EXPECT_EQ(estimate({}).by_geometry.initial.high, 1.);
  }


  TEST(Estimates, against_time_at_every_event)
  {
    std::vector<Record> records;
    for (std::uint64_t i = 0; i < 5; ++i)
      records.push_back(make_record(i));
    records[1]         = make_record(1, 2., 5.);
    records[2]         = make_record(2, 3.);
    records[4].outcome = Outcome::numerical_failure;

    const auto rows = estimate_against_time(records);
    ASSERT_EQ(rows.size(), 5U); // 0, 2, 3, 5, 10
    const std::vector<double> times    = {0., 2., 3., 5., 10.};
    const std::vector<double> initial  = {0., 0.25, 0.5, 0.5, 0.5};
    const std::vector<double> flooding = {0., 0., 0., 0.25, 0.25};
    for (unsigned int i = 0; i < 5; ++i)
      {
        EXPECT_EQ(rows[i].position, times[i]);
        EXPECT_EQ(rows[i].estimate.initial.estimate, initial[i]);
        EXPECT_EQ(rows[i].estimate.flooding.estimate, flooding[i]);
      }
    EXPECT_TRUE(std::isnan(rows[0].estimate.flooding_given.estimate));
    EXPECT_EQ(rows[2].estimate.flooding_given.estimate, 0.);
    EXPECT_EQ(rows[4].estimate.flooding_given.estimate, 0.5);
  }


  TEST(Estimates, a_flood_before_the_failure_counts_from_the_failure_on)
  {
    // Water runs over the second dyke at 5 s, which fails at 7 s.
    const auto rows =
      estimate_against_time({make_record(0, 2.), make_record(1, 7., 5.)});
    ASSERT_EQ(rows.size(), 5U); // 0, 2, 5, 7, 10
    EXPECT_EQ(rows[2].position, 5.);
    EXPECT_EQ(rows[2].estimate.flooding.estimate, 0.5);
    EXPECT_EQ(rows[2].estimate.flooding_given.estimate, 0.);
    EXPECT_EQ(rows[3].estimate.flooding_given.estimate, 0.5);
  }


  TEST(Estimates, against_time_on_a_grid_is_the_same_function)
  {
    const std::vector<Record> records = campaign();
    const auto                all     = estimate_against_time(records, 100000);
    const auto                grid    = estimate_against_time(records, 60);
    ASSERT_EQ(grid.size(), 60U);
    EXPECT_GT(all.size(), 150U);
    for (const EstimateRow &row : grid)
      {
        const auto after =
          std::find_if(all.begin(), all.end(), [&row](const EstimateRow &r) {
            return r.position > row.position;
          });
        const EstimateRow &same = *std::prev(after);
        EXPECT_EQ(row.estimate.initial.count, same.estimate.initial.count);
        EXPECT_EQ(row.estimate.flooding.count, same.estimate.flooding.count);
      }
    const ScenarioEstimate total = estimate(records);
    EXPECT_EQ(grid.back().estimate.flooding.count,
              total.by_geometry.flooding.count);
    EXPECT_EQ(grid.back().position, 10.);
  }


  TEST(Estimates, convergence_goes_by_number_not_by_order)
  {
    std::vector<Record> records = campaign();
    records[17].outcome         = Outcome::numerical_failure;
    const auto rows             = estimate_convergence(records, 50);
    EXPECT_LE(rows.size(), 50U);
    EXPECT_GE(rows.size(), 30U);
    EXPECT_EQ(rows.front().position, 1.);
    EXPECT_EQ(rows.back().position, 999.);
    EXPECT_EQ(rows.back().estimate.initial.count,
              estimate(records).by_geometry.initial.count);
    for (std::size_t i = 1; i < rows.size(); ++i)
      EXPECT_GT(rows[i].position, rows[i - 1].position);
    for (const EstimateRow &row : rows)
      {
        std::uint64_t count = 0, n = 0;
        for (std::size_t i = 0; n < row.position; ++i)
          if (i != 17)
            {
              ++n;
              count += records[i].initial_time >= 0.;
            }
        EXPECT_EQ(row.estimate.initial.count, count);
      }

    std::shuffle(records.begin(), records.end(), std::mt19937(5));
    const auto shuffled = estimate_convergence(records, 50);
    ASSERT_EQ(shuffled.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      EXPECT_EQ(shuffled[i].estimate.flooding.count,
                rows[i].estimate.flooding.count);
    EXPECT_TRUE(estimate_convergence({}).empty());
  }


  TEST(Histograms, by_outcome_with_empty_bins)
  {
    const auto bins = histogram({{0.25, Outcome::stable},
                                 {0.15, Outcome::stable},
                                 {0.25, Outcome::initial_failure},
                                 {0., Outcome::flooding},
                                 {0.1, Outcome::numerical_failure},
                                 {NAN, Outcome::stable},
                                 {-0.01, Outcome::initial_failure}},
                                0.05);
    ASSERT_EQ(bins.size(), 7U); // -0.05 ... 0.30
    EXPECT_NEAR(bins[0].low, -0.05, 1e-15);
    EXPECT_EQ(bins[0].counts[1], 1U);
    EXPECT_EQ(bins[1].counts[2], 1U);
    EXPECT_EQ(bins[3].counts[0] + bins[3].counts[1] + bins[3].counts[2], 0U);
    EXPECT_EQ(bins[4].counts[0], 1U); // 0.15 / 0.05 is below 3 by rounding
    EXPECT_EQ(bins[6].counts[0], 1U);
    EXPECT_EQ(bins[6].counts[1], 1U);
    EXPECT_TRUE(histogram({}, 1.).empty());
  }


  TEST(Histograms, residual_geometry_and_resistance)
  {
    std::vector<Record> records = {make_record(0),
                                   make_record(1, 2.),
                                   make_record(2, 2., 6.),
                                   make_record(3, 2., 6.),
                                   make_record(4, 2., 2.5)};
    for (Record &record : records)
      {
        record.residual_height = 4.9;
        record.residual_width  = 6.2;
      }
    records[3].residual_height                   = 4.6; // below the water
    const std::vector<std::vector<Slide>> slides = {
      {},
      {{2, 3, 6.4, 5, false}},
      {{2, 3, 6.1, 5, false}, {5, 6, 0, 4.7, true}},
      {{2, 3, 3.5, 5, false}, {5, 6, 0, 4.6, true}},
      {{2, 2.5, 1.3, 4.7, true}}};

    EXPECT_NEAR(residual_heights(records, 4.75)[1].value, 0.15, 1e-12);
    EXPECT_EQ(residual_heights(records, 4.75)[3].value, 0.);
    EXPECT_EQ(residual_widths(records)[0].value, 6.2);
    EXPECT_EQ(residual_widths(records)[2].value, 0.);

    const auto bins =
      residual_resistance(widths_after_first_slide(records, slides), 1.);
    ASSERT_EQ(bins.size(), 7U);
    EXPECT_EQ(bins[0].flooding.estimate, 1.); // flooded with its first slide
    EXPECT_TRUE(std::isnan(bins[1].flooding.estimate));
    EXPECT_EQ(bins[3].flooding.n, 1U);
    EXPECT_EQ(bins[6].flooding.n, 2U);
    EXPECT_EQ(bins[6].flooding.estimate, 0.5);
  }


  TEST(Histograms, classes_add_up)
  {
    std::vector<Record> records                  = {make_record(0),
                                                    make_record(1, 2.),
                                                    make_record(2, 2., 6.),
                                                    make_record(3),
                                                    make_record(4, 2.)};
    records[4].outcome                           = Outcome::numerical_failure;
    records[1].outer_slide.time                  = 2.;
    records[2].inner_slide.time                  = 2.;
    const std::vector<std::vector<Slide>> slides = {{},
                                                    {{2, 3, 6.4, 5, false}},
                                                    {{2, 3, 6.1, 5, false},
                                                     {5, 6, 0, 4.7, true}},
                                                    {},
                                                    {{2, 3, 6.4, 5, false}}};
    std::uint64_t                         n      = 0;
    for (const ClassCount &c : count_classes(records, slides, 0.))
      {
        n += c.share.count;
        EXPECT_EQ(c.share.n, 4U);
        const std::uint64_t expected =
          c.failure_class == FailureClass::none                         ? 2
          : c.failure_class == FailureClass::outer && !c.flooded        ? 1
          : c.failure_class == FailureClass::retrogressive && c.flooded ? 1
                                                                        : 0;
        EXPECT_EQ(c.share.count, expected) << to_string(c.failure_class);
      }
    EXPECT_EQ(n, 4U);
  }
} // namespace statistics_estimates
