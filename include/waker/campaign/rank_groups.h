// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_rank_groups_h
#define waker_campaign_rank_groups_h

#include <deal.II/base/mpi.h>

#include <waker/campaign/schedule.h>

#include <optional>

namespace Waker
{
  using namespace dealii;

  /**
   * The ranks of a campaign, in groups of so many with consecutive numbers, as
   * ranks of one node have. Each group computes one realisation at a time; its
   * first rank draws them, writes, and tells the others of the group.
   * Collective: construction and destruction.
   */
  class RankGroups
  {
  public:
    /// @param communicator of all ranks
    /// @param size ranks of a group; 1: each rank is a group
    /// @throws UserError "Campaign/Ranks per realisation" if it does not divide
    ///         the number of ranks
    RankGroups(const MPI_Comm communicator, const unsigned int size);
    ~RankGroups();
    RankGroups(const RankGroups &) = delete;
    RankGroups &
    operator=(const RankGroups &) = delete;

    /// Of the ranks of this rank's group.
    MPI_Comm
    group() const
    {
      return group_communicator;
    }

    /// Of the first ranks of all groups; no other rank has it.
    MPI_Comm
    first_ranks() const
    {
      return first_communicator;
    }

    bool
    is_first() const
    {
      return rank_in_group == 0;
    }

    /// Ranks of a group.
    unsigned int
    size() const
    {
      return n_in_group;
    }

    /// Of this rank's group.
    unsigned int
    number() const
    {
      return group_number;
    }

    unsigned int
    n_groups() const
    {
      return n_all_groups;
    }

    /// What the group's first rank says: compute this, or that there is nothing
    /// more. Collective in the group.
    /// @param task of the first rank; that of the others does not count
    std::optional<Task>
    share(const std::optional<Task> &task = {}) const;

  private:
    MPI_Comm     group_communicator = MPI_COMM_SELF;
    MPI_Comm     first_communicator;
    unsigned int n_in_group;
    unsigned int rank_in_group = 0;
    unsigned int group_number;
    unsigned int n_all_groups;
  };
} // namespace Waker

#endif
