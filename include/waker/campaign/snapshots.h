// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_snapshots_h
#define waker_campaign_snapshots_h

#include <waker/base/interrupt.h>
#include <waker/campaign/campaign.h>
#include <waker/simulation/run.h>

#include <cstdint>
#include <string>

namespace Waker
{
  class RankGroups;

  /**
   * Run one realisation of a campaign with full output to the folder
   * `directory`. As in the campaign, one that fails numerically is begun again
   * with half the time step, up to Campaign/Attempts times; the folder holds
   * the last attempt.
   *
   * @throws UserError before anything is written
   */
  template <int dim>
  RunStatus
  run_realisation(const Input        &input,
                  const std::uint64_t realisation,
                  const std::string  &directory,
                  const RunOptions   &options,
                  const MPI_Comm      communicator);

  /**
   * Run the realisations that section "Snapshots" asks for again, with full
   * output, to folder/snapshots/<scenario>-<realisation>. Those that are there
   * already stay. Collective over each group, which share them out.
   *
   * @param hash of the campaign in the folder
   * @return false if this group was interrupted
   */
  template <int dim>
  bool
  make_snapshots(const Scenarios   &scenarios,
                 const std::string &folder,
                 const std::string &hash,
                 const Interrupt   &interrupt,
                 const RankGroups  &groups);
} // namespace Waker

#endif
