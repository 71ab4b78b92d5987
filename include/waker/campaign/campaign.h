// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_campaign_h
#define waker_campaign_campaign_h

#include <deal.II/base/mpi.h>

#include <waker/base/interrupt.h>
#include <waker/campaign/input.h>
#include <waker/store/campaign_info.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace Waker
{
  /// One input per scenario; they differ in the swept parameter only.
  using Scenarios = std::vector<std::unique_ptr<Input>>;


  struct CampaignOptions
  {
    bool validate_only = false; // check everything, write nothing
    bool resume        = false; // go on with what is in the folder
    bool overwrite     = false; // an earlier campaign in the folder
    /// Others compute the rest: join what is in the folder.
    bool is_part = false;

    /// This process (or these ranks) computes every n-th task, beginning with
    /// number i - 1: part i of n.
    std::uint64_t chunk    = 1;
    std::uint64_t n_chunks = 1;
    /// Realisations first <= i < last of each scenario only.
    std::uint64_t first = 0;
    std::uint64_t last  = -1;

    /// Not 0: end cleanly. May be null.
    Interrupt interrupt;
    /// See RunOptions.
    std::function<void()> before_writing;
  };


  enum class CampaignStatus
  {
    completed,  // all that was asked for is done
    no_result,  // likewise, but every realisation failed numerically
    interrupted // what is finished is in the journals
  };


  /// What the scenarios have in common, for campaign.json.
  CampaignInfo
  campaign_info(const Scenarios &scenarios);


  /**
   * Compute the realisations that are missing in the folder Output/Directory,
   * by all ranks of the communicator, so many for each realisation as the
   * parameters say. Several processes may work in one folder at a time: parts
   * of a job array, say. Once all realisations are there, they are merged and
   * the snapshots made.
   *
   * @throws UserError before anything is written; or when a journal cannot be
   * written any more: what is finished stays
   */
  template <int dim>
  CampaignStatus
  run_campaign(const Scenarios       &scenarios,
               const CampaignOptions &options,
               const MPI_Comm         communicator);
} // namespace Waker

#endif
