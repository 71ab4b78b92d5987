// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/simulation/trial_table.h>

#include "output_temporary_folder.h"
#include <gtest/gtest.h>

namespace Waker::simulation_trial_table
{
  namespace
  {
    const std::string key = "0123abcd, to 40 s";


    std::string
    file(const TemporaryFolder &folder)
    {
      return folder.file("strength_reduction.csv");
    }


    void
    write_three(const TemporaryFolder &folder)
    {
      TrialTable table(folder.path, key, false);
      table.add(
        0.5, {TrialResult::undecided, 40., Outcome::still_moving, {}, {}, 1});
      table.add(2.,
                {TrialResult::failed,
                 1.25,
                 Outcome::initial_failure,
                 FailureReading::by_geometry,
                 Slopes::inner,
                 2});
      table.add(1. / 3.,
                {TrialResult::stable, 12.5, Outcome::stable, {}, {}, 1});
    }
  } // namespace


  TEST(Simulation, trials_come_back)
  {
    const TemporaryFolder folder;
    write_three(folder);
    const TrialTable table(folder.path, key, true);
    EXPECT_EQ(table.all().size(), 3u);
    EXPECT_EQ(table.n_damaged(), 0u);
    const Trial *trial = table.find(1. / 3.);
    ASSERT_NE(trial, nullptr);
    EXPECT_EQ(trial->result, TrialResult::stable);
    EXPECT_EQ(trial->time, 12.5);
    EXPECT_EQ(trial->outcome, Outcome::stable);
    EXPECT_FALSE(trial->reading);
    EXPECT_EQ(trial->slope, Slopes::none);
    EXPECT_EQ(table.find(0.5)->result, TrialResult::undecided);
    EXPECT_EQ(table.find(0.5)->outcome, Outcome::still_moving);
    trial = table.find(2.);
    EXPECT_EQ(trial->result, TrialResult::failed);
    EXPECT_EQ(trial->reading, FailureReading::by_geometry);
    EXPECT_EQ(trial->slope, Slopes::inner);
    EXPECT_EQ(trial->attempts, 2u);
    EXPECT_EQ(table.find(0.7), nullptr);

    EXPECT_EQ(TrialTable(folder.path, key, false).all().size(), 0u); // anew
    EXPECT_THROW(TrialTable(folder.path, "other", true), UserError);
    const TemporaryFolder empty;
    EXPECT_EQ(TrialTable(empty.path, key, true).all().size(), 0u);
  }


  TEST(Simulation, trials_with_a_flipped_bit_are_made_again)
  {
    const TemporaryFolder folder;
    write_three(folder);
    const std::string whole = get(file(folder));
    const std::size_t begin = whole.find("crc\n") + 4;
    for (std::size_t byte = begin; byte + 1 < whole.size(); ++byte)
      for (const unsigned int bit : {0u, 1u, 4u})
        {
          std::string damaged = whole;
          damaged[byte]       = static_cast<char>(damaged[byte] ^ (1 << bit));
          put(file(folder), damaged);
          const TrialTable table(folder.path, key, true);
          EXPECT_GE(table.n_damaged(), 1u) << byte;
          EXPECT_LE(table.all().size(), 2u) << byte;
          EXPECT_GE(table.all().size(), 1u) << byte;
        }
    // A last line that is cut short.
    put(file(folder), whole.substr(0, whole.size() - 20));
    EXPECT_EQ(TrialTable(folder.path, key, true).all().size(), 2u);
    EXPECT_EQ(TrialTable(folder.path, key, true).n_damaged(), 1u);
  }


  TEST(Simulation, trials_of_an_earlier_version_are_refused)
  {
    // They were judged by width and height, even where the hash is the same.
    const TemporaryFolder folder;
    put(file(folder),
        "# parameters 0123abcd, to 40 s\nfactor,failed,time_s,outcome\n"
        "0.5,0,40,end time\n2,1,1.25,initial failure\n");
    EXPECT_THROW(TrialTable(folder.path, key, true), UserError);
  }
} // namespace Waker::simulation_trial_table
