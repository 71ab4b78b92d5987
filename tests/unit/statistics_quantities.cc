// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/statistics/estimates.h>
#include <waker/statistics/quantities.h>

#include <cmath>
#include <gtest/gtest.h>

namespace statistics_quantities
{
  using namespace Waker;

  namespace
  {
    Record
    loaded(const double load, const double stop_time)
    {
      Record record;
      record.outcome        = Outcome::initial_failure;
      record.load           = load;
      record.load_stop_time = stop_time;
      return record;
    }
  } // namespace


  TEST(Quantities, have_moments_and_quantiles)
  {
    const Quantity q{"a", "m", {1., 2., 4., 9.}};
    EXPECT_EQ(q.mean(), 4.);
    EXPECT_NEAR(q.standard_deviation(), std::sqrt(38. / 3.), 1e-14);
    EXPECT_EQ(q.quantile(0.), 1.);
    EXPECT_EQ(q.quantile(1.), 9.);
    EXPECT_EQ(q.quantile(0.5), 3.);
    EXPECT_NEAR(q.quantile(0.9), 7.5, 1e-14);
    EXPECT_TRUE(std::isnan(Quantity{}.mean()));
    EXPECT_TRUE(std::isnan(Quantity{}.quantile(0.5)));
    const Quantity one{"b", "", {3.}};
    EXPECT_TRUE(std::isnan(one.standard_deviation()));
    EXPECT_EQ(one.quantile(0.3), 3.);
  }


  TEST(Quantities, an_ultimate_load_is_one_that_was_stopped)
  {
    std::vector<Record> records = {loaded(0.6, 3.),
                                   loaded(0.4, 2.),
                                   loaded(2., -1.)};
    records.push_back(loaded(9., 1.)); // does not count
    records.back().outcome = Outcome::numerical_failure;
    records.emplace_back(); // without a programme
    records.back().outcome = Outcome::stable;
    const auto list        = quantities(records);
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0].name, "ultimate load");
    EXPECT_EQ(list[0].values, (std::vector<double>{0.4, 0.6}));
    EXPECT_EQ(list[1].name, "load not stopped");
    EXPECT_EQ(list[1].values, std::vector<double>{2.});
  }


  TEST(Quantities, sliding_masses_are_those_of_the_records_that_watched_them)
  {
    Record slid;
    slid.outcome                       = Outcome::initial_failure;
    slid.sliding_masses                = SlidingMasses();
    slid.sliding_masses->whole_volume  = 8.;
    slid.sliding_masses->retrogression = 0.75;
    slid.sliding_masses->masses.resize(2);
    slid.sliding_masses->failed_volume = 2.;
    Record blind;
    blind.outcome   = Outcome::initial_failure;
    const auto list = quantities({slid, blind});
    ASSERT_GE(list.size(), 3u);
    EXPECT_EQ(list[0].name, "sliding masses");
    EXPECT_EQ(list[0].values, std::vector<double>{2.});
    EXPECT_EQ(list[1].name, "relative failure volume");
    EXPECT_NEAR(list[1].values[0], 0.25, 1e-14);
    EXPECT_EQ(list[2].values, std::vector<double>{0.75});
  }


  TEST(Quantities, say_when_dykes_fail)
  {
    std::vector<Record> records(3);
    records[0].outcome          = Outcome::flooding;
    records[0].inner_slide.time = 3.;
    records[0].initial_time     = 4.;
    records[0].flooding_time    = 90.;
    records[1].outcome          = Outcome::initial_failure;
    records[1].initial_time     = 2.;
    records[2].outcome          = Outcome::stable;
    const auto list             = quantities(records);
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0].name,
              "time of initial failure, by the first of its readings");
    EXPECT_EQ(list[0].values, (std::vector<double>{2., 3.}));
    EXPECT_EQ(list[1].name, "time of flooding");
    EXPECT_EQ(list[1].values, std::vector<double>{90.});
    EXPECT_EQ(list[1].unit, "s");
  }


  TEST(Quantities, without_water_nothing_is_said_of_flooding)
  {
    const std::vector<Record> records = {loaded(0.6, 3.), loaded(0.4, 2.)};
    const ScenarioEstimate    wet     = estimate(records),
                           dry        = estimate(records, false);
    EXPECT_EQ(wet.by_any.flooding.n, 2u);
    EXPECT_EQ(dry.by_any.flooding.n, 0u);
    EXPECT_EQ(dry.if_all_failed.flooding.n, 0u);
    EXPECT_EQ(dry.by_any.initial.n, wet.by_any.initial.n);
    EXPECT_FALSE(std::isfinite(dry.flooding().estimate));
  }
} // namespace statistics_quantities
