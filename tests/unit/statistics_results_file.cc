// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/file_error.h>
#include <waker/statistics/failure_class.h>
#include <waker/statistics/results_file.h>

#include "output_temporary_folder.h"
#include "processes.h"
#include "results_store.h"
#include "store_records.h"
#include "user_errors.h"
#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <hdf5_hl.h>
#include <limits>
#include <sys/resource.h>
#include <unistd.h>

namespace Waker::statistics_results_file
{
  using namespace Waker;
  using namespace ResultsStore;

  namespace
  {
    /// NaN for -1.
    double
    event(const double time)
    {
      return time < 0. ? std::numeric_limits<double>::quiet_NaN() : time;
    }


    void
    expect_same(const double obtained, const double expected)
    {
      if (std::isnan(expected))
        EXPECT_TRUE(std::isnan(obtained)) << obtained;
      else
        EXPECT_EQ(obtained, expected);
    }
  } // namespace


  TEST(Statistics, store_holds_what_the_records_hold)
  {
    const TemporaryFolder     folder;
    const std::vector<Record> records = six_records();
    write(folder.file("results.h5"), records);
    const OpenStore store(folder.file("results.h5"));
    EXPECT_EQ(store.values("realisation"), realisations);
    EXPECT_EQ(store.sizes("outcome"), (std::vector<hsize_t>{2, 5}));

    const auto outcome    = store.values("outcome");
    const auto classes    = store.values("failure_class");
    const auto attempts   = store.values("attempts");
    const auto linear     = store.values("linear_iterations");
    const auto initial    = store.values("initial_failure_time");
    const auto thesis     = store.values("initial_failure_time_thesis");
    const auto flooding   = store.values("flooding_time");
    const auto width      = store.values("residual_width");
    const auto height     = store.values("residual_height");
    const auto strength   = store.values("mean_strength");
    const auto area       = store.values("inward_area");
    const auto dx         = store.values("inward_dx");
    const auto dy         = store.values("inward_dy");
    const auto first_area = store.values("first_inward_area");
    const auto outward    = store.values("outward_area");

    std::vector<bool> run(10, false);
    for (const Record &record : records)
      {
        const auto        number = std::find(realisations.begin(),
                                      realisations.end(),
                                      double(record.realisation));
        const std::size_t at =
          5 * record.scenario + (number - realisations.begin());
        run[at]            = true;
        const auto slides  = find_slides(record, SlideParameters());
        const bool flooded = record.outcome == Outcome::flooding;
        EXPECT_EQ(outcome[at], static_cast<int>(record.outcome));
        EXPECT_EQ(classes[at], static_cast<int>(classify(record, slides, 0.)));
        EXPECT_EQ(attempts[at], record.attempts);
        EXPECT_EQ(linear[at], 3e12);
        expect_same(initial[at], event(record.initial_time));
        expect_same(thesis[at], event(record.initial_time_thesis));
        expect_same(flooding[at], event(record.flooding_time));
        EXPECT_EQ(width[at], record.residual_width);
        EXPECT_EQ(height[at], record.residual_height);
        EXPECT_EQ(strength[at], record.mean_strength);
        EXPECT_EQ(area[at], record.inward.area);
        expect_same(dx[at], flooded ? 4.5 : NAN);
        expect_same(dy[at], flooded ? -1.25 : NAN);
        expect_same(first_area[at], flooded ? 21. : NAN);
        EXPECT_EQ(outward[at], 0.);
      }
    for (std::size_t at = 0; at < run.size(); ++at)
      if (!run[at])
        {
          EXPECT_EQ(outcome[at], -1.);
          EXPECT_EQ(classes[at], -1.);
          EXPECT_EQ(attempts[at], -1.);
          EXPECT_EQ(linear[at], -1.);
          for (const auto *values :
               {&initial, &flooding, &width, &strength, &area, &outward})
            EXPECT_TRUE(std::isnan((*values)[at]));
        }
    EXPECT_EQ(std::count(run.begin(), run.end(), true), 6);
  }


  TEST(Statistics, store_holds_slides_and_pads_them)
  {
    const TemporaryFolder folder;
    std::vector<Record>   records = six_records();
    records.push_back(synthetic_record(0, 7)); // of which only the first slide
    records.back().trace.resize(4);
    records.back().flooding_time = -1.;
    records.back().outcome       = Outcome::initial_failure;
    write(folder.file("results.h5"), records);
    const OpenStore store(folder.file("results.h5"));
    EXPECT_EQ(store.values("n_slides")[4], 1.);
    EXPECT_FALSE(std::isnan(store.values("slide_start")[2 * 4]));
    EXPECT_TRUE(std::isnan(store.values("slide_start")[2 * 4 + 1]));

    const auto expected =
      find_slides(synthetic_record(1, 7), SlideParameters());
    ASSERT_EQ(expected.size(), 2u); // or the case shows nothing
    ASSERT_EQ(store.sizes("slide_start"), (std::vector<hsize_t>{2, 5, 2}));

    const std::size_t at = 5 + 4; // scenario 1, realisation 7
    EXPECT_EQ(store.values("n_slides")[at], 2.);
    EXPECT_EQ(store.values("n_slides")[0], 0.);  // stands
    EXPECT_EQ(store.values("n_slides")[5], -1.); // not run
    EXPECT_EQ(store.values("width_after_first_slide")[at], expected[0].width);
    EXPECT_EQ(store.values("height_after_first_slide")[at], expected[0].height);
    EXPECT_TRUE(std::isnan(store.values("width_after_first_slide")[0]));
    for (const std::size_t j : {0, 1})
      {
        EXPECT_EQ(store.values("slide_start")[2 * at + j], expected[j].start);
        EXPECT_EQ(store.values("slide_end")[2 * at + j], expected[j].end);
        EXPECT_EQ(store.values("slide_width")[2 * at + j], expected[j].width);
        EXPECT_EQ(store.values("slide_height")[2 * at + j], expected[j].height);
        EXPECT_TRUE(std::isnan(store.values("slide_start")[j]));
      }
  }


  TEST(Statistics, store_holds_sliding_masses_and_pads_them)
  {
    const TemporaryFolder folder;
    std::vector<Record>   records = six_records();
    records[1].sliding_masses     = synthetic_masses(3); // realisation 1
    records[2].sliding_masses     = SlidingMasses();
    records[2].sliding_masses->whole_volume = 24.25;
    write(folder.file("results.h5"), records);
    const OpenStore store(folder.file("results.h5"));
    ASSERT_EQ(store.sizes("mass_time"), (std::vector<hsize_t>{2, 5, 2}));
    const SlidingMasses masses = synthetic_masses(3);
    for (const std::size_t j : {0, 1})
      {
        const SlidingMass &mass = masses.masses[j];
        EXPECT_EQ(store.values("mass_time")[2 * 1 + j], mass.time);
        EXPECT_EQ(store.values("mass_volume")[2 * 1 + j], mass.volume);
        EXPECT_EQ(store.values("mass_width")[2 * 1 + j], mass.width);
        EXPECT_EQ(store.values("mass_x")[2 * 1 + j], mass.centre[0]);
        EXPECT_EQ(store.values("mass_y")[2 * 1 + j], mass.centre[1]);
        EXPECT_EQ(store.values("mass_z")[2 * 1 + j], mass.centre[2]);
        EXPECT_EQ(store.values("mass_x_from")[2 * 1 + j], mass.lower[0]);
        EXPECT_EQ(store.values("mass_x_to")[2 * 1 + j], mass.upper[0]);
        EXPECT_EQ(store.values("mass_z_from")[2 * 1 + j], mass.lower[2]);
        EXPECT_EQ(store.values("mass_z_to")[2 * 1 + j], mass.upper[2]);
        EXPECT_TRUE(std::isnan(store.values("mass_time")[2 * 2 + j]));
      }
    const double volume = masses.failed_volume;
    EXPECT_EQ(store.values("body_volume")[1], 24.25);
    EXPECT_EQ(store.values("stable_volume")[1], 24.25 - volume);
    EXPECT_EQ(store.values("relative_failure_volume")[1], volume / 24.25);
    EXPECT_EQ(store.values("retrogression_distance")[1], masses.retrogression);
    EXPECT_EQ(store.values("damaged_crest_width")[1], 4.25);
    EXPECT_EQ(store.values("first_mass_time")[1], masses.masses[0].time);
    EXPECT_EQ(store.values("first_mass_volume")[1], masses.masses[0].volume);
    EXPECT_EQ(store.values("first_mass_width")[1], 0.7);
    EXPECT_EQ(store.values("n_masses")[1], 2.);
    // Its offset is 1 m back, of a half length of 4/7 m.
    EXPECT_EQ(store.values("n_masses_behind_off_centre")[1] +
                store.values("n_masses_side")[1],
              1.);
    // Nothing has slid; nobody knows; not run.
    EXPECT_EQ(store.values("n_masses")[2], 0.);
    EXPECT_EQ(store.values("relative_failure_volume")[2], 0.);
    EXPECT_TRUE(std::isnan(store.values("first_mass_time")[2]));
    for (const std::size_t at : {0, 5})
      {
        EXPECT_EQ(store.values("n_masses")[at], -1.);
        EXPECT_EQ(store.values("n_masses_side")[at], -1.);
        EXPECT_TRUE(std::isnan(store.values("relative_failure_volume")[at]));
      }
  }
} // namespace Waker::statistics_results_file
