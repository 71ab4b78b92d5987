// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_tasks_h
#define waker_campaign_tasks_h

#include <waker/base/interrupt.h>
#include <waker/campaign/realisation_runner.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace Waker
{
  class CampaignWriter;
  class FolderWatch;
  class Log;
  class RankGroups;
  class Schedule;
  struct CampaignInfo;
  struct Work;

  /// One per scenario.
  template <int dim>
  using Runners = std::vector<std::unique_ptr<RealisationRunner<dim>>>;


  /// What the realisations of a campaign have in common.
  struct TaskSetup
  {
    std::uint64_t seed;
    double        checkpoint_interval; // s of wall time
    std::uint64_t chunk, n_chunks;     // see CampaignOptions
    Interrupt     interrupt;
    std::string   folder;
  };


  /**
   * Draw realisations until none is left, compute them with the other ranks of
   * the group, and write what came out: what the first rank of a group does.
   * Collective among first ranks.
   *
   * @param writer of this rank
   * @param work of this rank is added
   * @return false if interrupted
   */
  template <int dim>
  bool
  compute_tasks(const Runners<dim>   &runners,
                const Schedule       &schedule,
                const TaskSetup      &setup,
                const CampaignInfo   &info,
                const RankGroups     &groups,
                const CampaignWriter &writer,
                FolderWatch          &watch,
                Work                 &work,
                Log                  &log);

  /// What the other ranks of the group do meanwhile.
  /// @return false if interrupted
  template <int dim>
  bool
  follow_tasks(const Runners<dim> &runners,
               const TaskSetup    &setup,
               const RankGroups   &groups,
               Work               &work);
} // namespace Waker

#endif
