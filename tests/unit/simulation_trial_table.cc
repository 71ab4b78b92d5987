// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/simulation/trial_table.h>

#include "output_temporary_folder.h"
#include <gtest/gtest.h>

namespace Waker
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
      table.add(0.5, {false, 40., "end time"});
      table.add(2., {true, 1.25, "initial failure"});
      table.add(1. / 3., {false, 12.5, "never failed and at rest"});
    }
  } // namespace


  TEST(Simulation, trials_come_back)
  {
    const TemporaryFolder folder;
    write_three(folder);
    const TrialTable table(folder.path, key, true);
    EXPECT_EQ(table.size(), 3u);
    EXPECT_EQ(table.n_damaged(), 0u);
    const Trial *trial = table.find(1. / 3.);
    ASSERT_NE(trial, nullptr);
    EXPECT_FALSE(trial->failed);
    EXPECT_EQ(trial->time, 12.5);
    EXPECT_EQ(trial->outcome, "never failed and at rest");
    EXPECT_TRUE(table.find(2.)->failed);
    EXPECT_EQ(table.find(0.7), nullptr);

    EXPECT_EQ(TrialTable(folder.path, key, false).size(), 0u); // anew
    EXPECT_THROW(TrialTable(folder.path, "other", true), UserError);
    const TemporaryFolder empty;
    EXPECT_EQ(TrialTable(empty.path, key, true).size(), 0u);
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
          EXPECT_LE(table.size(), 2u) << byte;
          EXPECT_GE(table.size(), 1u) << byte;
        }
    // A last line that is cut short.
    put(file(folder), whole.substr(0, whole.size() - 20));
    EXPECT_EQ(TrialTable(folder.path, key, true).size(), 2u);
    EXPECT_EQ(TrialTable(folder.path, key, true).n_damaged(), 1u);
  }


  // Tables of version 0.1 stay readable: change this text never.
  TEST(Simulation, trials_of_an_earlier_version_are_read)
  {
    const TemporaryFolder folder;
    put(file(folder),
        "# parameters 0123abcd, to 40 s\nfactor,failed,time_s,outcome\n"
        "0.5,0,40,end time\n2,1,1.25,initial failure\n1.5,7,1,x\n1.2,1,1e3");
    const TrialTable table(folder.path, key, true);
    EXPECT_EQ(table.size(), 2u);
    EXPECT_EQ(table.n_damaged(), 2u);
    EXPECT_TRUE(table.find(2.)->failed);
    table.write();
    EXPECT_EQ(TrialTable(folder.path, key, true).size(), 2u);
    EXPECT_NE(get(file(folder)).find("outcome,crc\n"), std::string::npos);
  }
} // namespace Waker
