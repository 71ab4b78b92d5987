// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/campaign/realisation_runner.h>
#include <waker/statistics/estimates.h>
#include <waker/statistics/event_tree.h>
#include <waker/statistics/histograms.h>

#include "campaign_random_dyke.h"
#include <gtest/gtest.h>

namespace statistics_undecided
{
  // What campaigns make of dykes whose water rises late.

  namespace
  {
    using namespace Waker;
    using namespace RandomDyke;

    std::vector<Record>
    campaign(const std::vector<std::string> &more,
             const std::string              &mean = "16",
             const std::string              &rise = "0: 0, 3: 0, 4: 2")
    {
      std::vector<std::string> settings = {field + "Mean=" + mean,
                                           "Time stepping/Time step=0.05",
                                           "Water/Level=4.5",
                                           "Water/Rise=" + rise};
      settings.insert(settings.end(), more.begin(), more.end());
      const auto           input = coarse(settings);
      RealisationRunner<2> runner(input->simulation,
                                  input->reliability.fields,
                                  1,
                                  MPI_COMM_SELF);
      std::vector<Record>  records;
      for (std::uint64_t i = 0; i < 3; ++i)
        records.push_back(*runner.run(1, i, nullptr));
      return records;
    }


    TEST(RealisationRunner, water_that_rises_late_floods_every_dyke)
    {
      const std::vector<Record> records = campaign({});
      for (const Record &record : records)
        {
          EXPECT_EQ(record.outcome, Outcome::flooding);
          EXPECT_GT(record.flooding_time, 3.1);
          EXPECT_LT(record.flooding_time, 3.5);
          // Nothing but the water has moved.
          EXPECT_FALSE(record.failed());
          EXPECT_EQ(record.initial_time_thesis, -1.);
          EXPECT_EQ(classify(record,
                             find_slides(record, SlideParameters()),
                             0.),
                    FailureClass::overflow);
        }
      const ScenarioEstimate e = estimate(records);
      EXPECT_EQ(e.by_geometry.flooding.estimate, 1.);
      EXPECT_EQ(e.by_any.initial.estimate, 0.);
      EXPECT_EQ(e.by_any.flooding_given.n, 0u);
      EXPECT_EQ(estimate_against_time(records).back().estimate.flooding.count,
                3u);
      EXPECT_EQ(estimate_convergence(records).back().estimate.flooding.count,
                3u);
      const std::vector<std::vector<Slide>> none(records.size());
      EXPECT_EQ(build_event_tree(slide_sequences(records, none), 4).probability,
                1.);
      unsigned int n = 0;
      for (const ClassCount &c : count_classes(records, none, 0.))
        n += c.failure_class == FailureClass::overflow ? c.share.count : 0;
      EXPECT_EQ(n, 3u);
    }


    TEST(RealisationRunner, an_end_before_the_water_rises_decides_nothing)
    {
      const std::vector<Record> records =
        campaign({"Time stepping/End time=2.5"});
      for (const Record &record : records)
        {
          EXPECT_EQ(record.outcome, Outcome::loads_change);
          ASSERT_TRUE(record.unrest);
          EXPECT_TRUE(record.unrest->loads_change);
          EXPECT_FALSE(record.unrest->at_box);
        }
      const ScenarioEstimate e = estimate(records);
      EXPECT_EQ(e.n, 0u);
      EXPECT_EQ(e.n_loads_change, 3u);
      EXPECT_EQ(e.if_all_failed.flooding.estimate, 1.);
      EXPECT_EQ(e.if_none_failed.flooding.estimate, 0.);
    }


    TEST(RealisationRunner, a_slide_that_is_cut_short_is_not_final)
    {
      const std::vector<Record> records =
        campaign({"Stop rules/On initial failure=true"}, "8", "0");
      for (const Record &record : records)
        {
          EXPECT_EQ(record.outcome, Outcome::initial_failure);
          ASSERT_TRUE(record.unrest);
          EXPECT_TRUE(record.unrest->moving);
        }
      const ScenarioEstimate e = estimate(records);
      EXPECT_EQ(e.n, 3u);
      EXPECT_EQ(e.n_not_final, 3u);
      EXPECT_EQ(e.by_any.initial.estimate, 1.); // seen by displacement
      EXPECT_EQ(e.by_any.flooding.estimate, 0.);
      EXPECT_EQ(e.if_all_failed.flooding.estimate, 1.);
    }
  } // namespace
} // namespace statistics_undecided
