// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/campaign/folder_keeper.h>
#include <waker/campaign/progress.h>
#include <waker/campaign/schedule.h>
#include <waker/store/campaign_files.h>

#include "output_temporary_folder.h"
#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <random>
#include <set>
#include <tuple>
#include <vector>

namespace campaign_progress
{
  namespace
  {
    using namespace Waker;

    Record
    record(const std::uint64_t realisation, const bool floods)
    {
      Record r;
      r.realisation   = realisation;
      r.outcome       = floods ? Outcome::flooding : Outcome::stable;
      r.initial_time  = floods ? 3. : -1.;
      r.flooding_time = floods ? 6. : -1.;
      return r;
    }


    TEST(Schedule, deals_out_each_realisation_once_batch_by_batch)
    {
      for (const auto &[n_scenarios, first, last, batch] :
           {std::tuple{1u, 0ull, 10ull, 4ull},
            {3u, 0ull, 10ull, 4ull},
            {3u, 5ull, 23ull, 4ull},
            {2u, 5ull, 7ull, 50ull},
            {2u, 8ull, 16ull, 4ull}})
        {
          const Schedule schedule(n_scenarios, first, last, batch);
          EXPECT_EQ(schedule.size(), n_scenarios * (last - first));
          std::set<std::pair<unsigned int, std::uint64_t>> seen;
          std::uint64_t                                    highest = 0;
          for (std::uint64_t k = 0; k < schedule.size(); ++k)
            {
              const Task task = schedule.task(k);
              EXPECT_TRUE(
                seen.insert({task.scenario, task.realisation}).second);
              EXPECT_LT(task.scenario, n_scenarios);
              EXPECT_GE(task.realisation, first);
              EXPECT_LT(task.realisation, last);
              EXPECT_EQ(task.batch, task.realisation / batch);
              EXPECT_GE(task.batch, highest) << "batches come in order";
              highest = task.batch;
            }
          EXPECT_EQ(seen.size(), schedule.size());
        }
    }


    TEST(Progress, stop_rule_does_not_depend_on_the_order_of_the_work)
    {
      CampaignParameters parameters;
      parameters.realisations             = 1000;
      parameters.batch                    = 20;
      parameters.coefficient_of_variation = 0.3;

      std::mt19937        generator(5);
      std::vector<Record> records;
      for (std::uint64_t i = 0; i < 1000; ++i)
        records.push_back(record(i, generator() % 10 == 0));
      std::uint64_t expected = 0;
      for (unsigned int order = 0; order < 10; ++order)
        {
          Progress progress(parameters, 1);
          for (const Record &r : records)
            progress.add(r);
          if (order == 0)
            expected = progress.end(0);
          EXPECT_EQ(progress.end(0), expected);
          EXPECT_EQ(progress.counts(0).n, expected);
          EXPECT_TRUE(progress.complete());
          EXPECT_TRUE(progress.stopped(0));
          std::shuffle(records.begin(), records.end(), generator);
        }
      // 11 floods give a coefficient of variation of 0.3 sqrt(1 - P).
      EXPECT_GT(expected, 40u);
      EXPECT_LT(expected, 300u);
      EXPECT_EQ(expected % 20, 0u);
    }


    TEST(Progress, a_gap_holds_the_stop_rule_up)
    {
      CampaignParameters parameters;
      parameters.realisations     = 100;
      parameters.batch            = 10;
      parameters.initial_failures = 3;
      Progress progress(parameters, 1);
      for (std::uint64_t i = 0; i < 50; ++i)
        if (i != 4)
          progress.add(record(i, i % 2 == 0));
      EXPECT_EQ(progress.end(0), 100u);
      EXPECT_EQ(progress.n_done(), 49u);
      progress.add(record(4, true));
      EXPECT_EQ(progress.end(0), 10u);
      EXPECT_EQ(progress.counts(0).n_initial, 5u);
      EXPECT_TRUE(progress.complete());

      // Once more the same, and numbers of a longer campaign: no change.
      progress.add(record(4, true));
      progress.add(record(100, true));
      EXPECT_EQ(progress.n_done(), 10u);
    }


    TEST(Progress, scenarios_stop_by_themselves)
    {
      CampaignParameters parameters;
      parameters.realisations     = 40;
      parameters.batch            = 10;
      parameters.initial_failures = 5;
      Progress progress(parameters, 2);
      for (std::uint64_t i = 0; i < 40; ++i)
        for (unsigned int s = 0; s < 2; ++s)
          {
            Record r   = record(i, s == 1);
            r.scenario = s;
            progress.add(r);
          }
      EXPECT_EQ(progress.end(0), 40u);
      EXPECT_FALSE(progress.stopped(0));
      EXPECT_EQ(progress.end(1), 10u);
      EXPECT_TRUE(progress.stopped(1));
      EXPECT_EQ(progress.n_wanted(), 50u);
    }


    TEST(Progress, the_undecided_count_for_no_probability)
    {
      Counts counts;
      for (const Outcome outcome : {Outcome::stable,
                                    Outcome::initial_failure,
                                    Outcome::flooding,
                                    Outcome::numerical_failure,
                                    Outcome::still_moving,
                                    Outcome::loads_change,
                                    Outcome::stopped_by_box})
        {
          Record record;
          record.outcome      = outcome;
          record.initial_time = outcome == Outcome::stable ? -1. : 2.;
          counts.add(Event(record));
        }
      EXPECT_EQ(counts.n, 7u);
      EXPECT_EQ(counts.n_failures, 1u);
      EXPECT_EQ(counts.n_undecided, 3u);
      EXPECT_EQ(counts.n_decided(), 3u);
      EXPECT_EQ(counts.n_initial, 2u);
    }


    TEST(Progress, rules_ignore_numerical_failures_but_count_them)
    {
      CampaignParameters parameters;
      parameters.interval_width       = 0.2;
      parameters.minimum_realisations = 30;
      Counts counts;
      counts.n          = 1000;
      counts.n_failures = 1000;
      EXPECT_FALSE(enough(parameters, counts));
      counts.n_failures = 800;
      EXPECT_TRUE(enough(parameters, counts)); // 0 of 200
      counts.n          = 29;
      counts.n_failures = 0;
      EXPECT_FALSE(enough(parameters, counts)); // 0 of 29: 0.119
      counts.n = 30;
      EXPECT_TRUE(enough(parameters, counts));
      counts.n_undecided = 15;
      EXPECT_FALSE(enough(parameters, counts)); // 0 of 15: 0.218
      counts.n_undecided        = 0;
      parameters.interval_width = 0.1;
      EXPECT_FALSE(enough(parameters, counts));
    }


    // Else a folder that was moved gives one realisation the numbers of
    // another.
    TEST(Campaign, what_is_kept_is_of_its_realisation_only)
    {
      const TemporaryFolder folder;
      const auto            keeper = [&](const unsigned int  scenario,
                              const std::uint64_t realisation) {
        return FolderKeeper(folder.path,
                            scenario,
                            realisation,
                            "0123456789abcdef",
                            1.,
                            [](double) {});
      };
      const auto place = [&](const unsigned int  scenario,
                             const std::uint64_t realisation) {
        return running_folder(folder.path, scenario, realisation);
      };
      keeper(0, 0).keep(5, 0.5, "all that is known");
      EXPECT_EQ(keeper(0, 0).earlier(), "all that is known");
      std::filesystem::rename(place(0, 0), place(0, 1));
      EXPECT_EQ(keeper(0, 1).earlier(), "");
      std::filesystem::rename(place(0, 1), place(1, 0));
      EXPECT_EQ(keeper(1, 0).earlier(), "");
      std::filesystem::rename(place(1, 0), place(0, 0));
      EXPECT_EQ(keeper(0, 0).earlier(), "all that is known");
    }
  } // namespace
} // namespace campaign_progress
