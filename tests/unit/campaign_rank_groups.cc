// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/campaign/rank_groups.h>

#include "user_errors.h"
#include <gtest/gtest.h>

// Of one rank and, by tests/cases/ranks.py, of several.

namespace Waker
{
  namespace campaign_rank_groups
  {
    TEST(Ranks, each_is_a_group_of_its_own)
    {
      const RankGroups groups(MPI_COMM_WORLD, 1);
      EXPECT_EQ(groups.number(),
                Utilities::MPI::this_mpi_process(MPI_COMM_WORLD));
      EXPECT_EQ(groups.n_groups(),
                Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD));
      EXPECT_TRUE(groups.is_first());
      EXPECT_EQ(Utilities::MPI::n_mpi_processes(groups.group()), 1);
      EXPECT_FALSE(groups.share({}));
      EXPECT_EQ(groups.share(Task{1, 17, 3})->realisation, 17);
    }


    TEST(Ranks, the_first_of_a_group_tells_the_others)
    {
      const unsigned int n = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
      const unsigned int rank =
        Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
      const RankGroups groups(MPI_COMM_WORLD, n);
      EXPECT_EQ(groups.n_groups(), 1);
      EXPECT_EQ(groups.number(), 0);
      EXPECT_EQ(groups.size(), n);
      EXPECT_EQ(groups.is_first(), rank == 0);
      EXPECT_EQ(Utilities::MPI::this_mpi_process(groups.group()), rank);
      if (groups.is_first())
        {
          EXPECT_EQ(Utilities::MPI::n_mpi_processes(groups.first_ranks()), 1);
        }

      // What the others bring along does not count.
      const std::uint64_t large = std::uint64_t(1) << 40;
      const auto          task =
        groups.share(rank == 0 ? Task{2, large, 7} : Task{9, 9, 9});
      ASSERT_TRUE(task);
      EXPECT_EQ(task->scenario, 2);
      EXPECT_EQ(task->realisation, large);
      EXPECT_EQ(task->batch, 7);
      EXPECT_FALSE(
        groups.share(rank == 0 ? std::optional<Task>() : Task{9, 9, 9}));
    }


    TEST(Ranks, are_not_left_over)
    {
      const unsigned int n = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
      EXPECT_USER_ERROR(RankGroups(MPI_COMM_WORLD, n + 1),
                        "Campaign/Ranks per realisation",
                        std::to_string(n) + " rank(s)");
      EXPECT_USER_ERROR(RankGroups(MPI_COMM_WORLD, 0),
                        "Campaign/Ranks per realisation",
                        "is 0");
    }
  } // namespace campaign_rank_groups
} // namespace Waker
