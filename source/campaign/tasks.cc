// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/log.h>
#include <waker/campaign/campaign_text.h>
#include <waker/campaign/folder_keeper.h>
#include <waker/campaign/folder_watch.h>
#include <waker/campaign/rank_groups.h>
#include <waker/campaign/schedule.h>
#include <waker/campaign/tasks.h>
#include <waker/store/campaign_info.h>
#include <waker/store/campaign_writer.h>
#include <waker/store/journal.h>

#include <chrono>
#include <optional>

namespace Waker
{
  namespace
  {
    /// Compute a realisation by this rank and the others of its group.
    template <int dim>
    std::optional<Record>
    compute_task(const Runners<dim> &runners,
                 const Task         &task,
                 const TaskSetup    &setup,
                 Keeper             &keeper,
                 Work               &work)
    {
      // Not the wall time of the record, of which another process may have
      // spent a part.
      const auto            begun  = std::chrono::steady_clock::now();
      std::optional<Record> record = runners[task.scenario]->run(
        setup.seed, task.realisation, setup.interrupt, keeper);
      work.busy +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begun)
          .count();
      return record;
    }
  } // namespace


  template <int dim>
  bool
  compute_tasks(const Runners<dim>   &runners,
                const Schedule       &schedule,
                const TaskSetup      &setup,
                const CampaignInfo   &info,
                const RankGroups     &groups,
                const CampaignWriter &campaign_writer,
                FolderWatch          &watch,
                Work                 &work,
                Log                  &log)
  {
    IndexCounter                 counter(groups.first_ranks());
    std::optional<JournalWriter> writer;
    Progress                    &progress = watch.progress;
    std::uint64_t                batch    = -1;
    while (true)
      {
        const std::uint64_t number =
          counter.next() * setup.n_chunks + setup.chunk - 1;
        if (number >= schedule.size())
          {
            groups.share({}); // nothing more
            return true;
          }
        const Task task = schedule.task(number);
        if (task.batch != batch)
          {
            watch.poll();
            batch = task.batch;
          }
        if (task.realisation >= progress.end(task.scenario) ||
            progress.is_done(task.scenario, task.realisation))
          continue;
        // Another process may be at it, or have finished it just now.
        const auto claim =
          campaign_writer.claim(task.scenario, task.realisation);
        if (!claim)
          continue;
        watch.poll();
        if (progress.is_done(task.scenario, task.realisation))
          continue;

        const double end_time =
          runners[task.scenario]->first_case().parameters.time.end_time;
        FolderKeeper keeper(setup.folder,
                            task.scenario,
                            task.realisation,
                            info.hash,
                            setup.checkpoint_interval,
                            [&](const double time) {
                              if (log.progress_due())
                                log.progress(
                                  (progress.n_done() + time / end_time) /
                                    progress.n_wanted(),
                                  progress_text(progress, info) +
                                    running_text(task.realisation, time));
                            });
        groups.share(task);
        std::optional<Record> record =
          compute_task(runners, task, setup, keeper, work);
        if (!record)
          return false; // which the others of the group see, too
        record->scenario = task.scenario;
        if (!writer)
          writer.emplace(setup.folder, info.hash);
        writer->append(*record);
        keeper.remove();
        progress.add(*record);
        ++work.n;
        work.fields += record->field_time;

        if (log.progress_due())
          {
            watch.poll();
            log.progress(double(progress.n_done()) / progress.n_wanted(),
                         progress_text(progress, info));
          }
      }
  }


  template <int dim>
  bool
  follow_tasks(const Runners<dim> &runners,
               const TaskSetup    &setup,
               const RankGroups   &groups,
               Work               &work)
  {
    Keeper nobody;
    while (const std::optional<Task> task = groups.share())
      if (!compute_task(runners, *task, setup, nobody, work))
        return false;
    return true;
  }


  template bool
  compute_tasks(const Runners<2> &,
                const Schedule &,
                const TaskSetup &,
                const CampaignInfo &,
                const RankGroups &,
                const CampaignWriter &,
                FolderWatch &,
                Work &,
                Log &);
  template bool
  compute_tasks(const Runners<3> &,
                const Schedule &,
                const TaskSetup &,
                const CampaignInfo &,
                const RankGroups &,
                const CampaignWriter &,
                FolderWatch &,
                Work &,
                Log &);
  template bool
  follow_tasks(const Runners<2> &,
               const TaskSetup &,
               const RankGroups &,
               Work &);
  template bool
  follow_tasks(const Runners<3> &,
               const TaskSetup &,
               const RankGroups &,
               Work &);
} // namespace Waker
