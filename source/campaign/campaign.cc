// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/hash.h>
#include <waker/base/log.h>
#include <waker/base/ranks.h>
#include <waker/base/sizes.h>
#include <waker/campaign/campaign_folder.h>
#include <waker/campaign/campaign_text.h>
#include <waker/campaign/folder_watch.h>
#include <waker/campaign/rank_groups.h>
#include <waker/campaign/schedule.h>
#include <waker/campaign/snapshots.h>
#include <waker/campaign/tasks.h>
#include <waker/case/sizes.h>
#include <waker/output/files.h>
#include <waker/output/output_folder.h>
#include <waker/output/summary.h>
#include <waker/particles/layer.h>
#include <waker/simulation/describe.h>
#include <waker/statistics/report.h>
#include <waker/store/campaign_files.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>

namespace Waker
{
  CampaignInfo
  campaign_info(const Scenarios &scenarios)
  {
    const Input  &first = *scenarios[0];
    CampaignInfo  info;
    const Summary program; // knows what it was built from
    info.version         = program.version;
    info.compiler        = program.compiler;
    info.build_flags     = program.build_flags;
    info.seed            = first.reliability.campaign.seed;
    info.realisations    = first.reliability.campaign.realisations;
    info.swept_parameter = first.reliability.sweep.parameter;
    info.parameters      = first.simulation.text;

    const std::vector<std::string> values = first.reliability.sweep.list();
    for (std::size_t s = 0; s < scenarios.size(); ++s)
      {
        const Input &input = *scenarios[s];
        ScenarioInfo scenario;
        scenario.value = values[s];
        scenario.hash  = input.campaign_hash;
        if (input.simulation.water.stands())
          scenario.water_level = input.simulation.water.level;
        const GridParameters &grid    = input.simulation.grid;
        const double          z_begin = grid.lower_corner.back();
        const double          z_end   = grid.upper_corner.back();
        const auto           &layers  = input.simulation.layers;
        if (!layers.empty())
          scenario.crest_level = drawn_crest(
            layers, input.simulation.dimension, z_begin, z_end, grid.cell_size);
        for (const LayerParameters &layer : layers)
          // NaN is no number to compare with.
          scenario.base_level =
            std::fmin(scenario.base_level,
                      level_range(layer, z_begin, z_end)[0]);
        if (!input.reliability.fields.fields.empty())
          scenario.scales = input.reliability.fields.fields[0].scales;
        info.scenarios.push_back(scenario);
        info.hash += (s > 0 ? "-" : "") + scenario.hash;
      }
    info.hash = hash_of_text(info.hash);
    return info;
  }


  namespace
  {
    std::string
    log_name(const CampaignOptions &options)
    {
      if (options.n_chunks > 1)
        return chunk_log_name(options.chunk, options.n_chunks);
      if (options.first > 0 || options.last != std::uint64_t(-1))
        return interval_log_name(options.first);
      return file_name(OutputFile::log);
    }


    /// @param communicator of the ranks that compute a realisation together
    template <int dim>
    Runners<dim>
    make_runners(const Scenarios &scenarios,
                 const MPI_Comm   communicator,
                 Log             &log)
    {
      Runners<dim> runners;
      for (const auto &scenario : scenarios)
        {
          const std::size_t      n     = runners.size();
          const SweepParameters &sweep = scenario->reliability.sweep;
          const std::string      swept = sweep.parameter;
          const std::string      value = swept.empty() ? "" : sweep.list()[n];
          try
            {
              runners.push_back(std::make_unique<RealisationRunner<dim>>(
                scenario->simulation,
                scenario->reliability.fields,
                scenario->reliability.campaign.attempts,
                communicator,
                initial_stress_progress(scenario->simulation.initial_stress,
                                        log)));
            }
          catch (const NumericalFailure &failure)
            {
              throw NumericalFailure(
                swept.empty() ? failure.what()
                              : "scenario " + std::to_string(n) + " (" + swept +
                                  " = " + value + "): " + failure.what());
            }
          catch (const UserError &error)
            {
              if (swept.empty() || error.where == swept)
                throw;
              // Where the scenarios before were good only the value can be
              // wrong.
              if (n > 0)
                throw UserError(swept,
                                "is " + value + ": " + error.where + ": " +
                                  error.problem,
                                error.allowed);
              throw UserError(error.where,
                              error.problem + " (" + swept + " is " + value +
                                ")",
                              error.allowed);
            }
        }
      return runners;
    }


    /// Each rank needs as much (bytes): is there enough for those that share
    /// this machine?
    void
    check_memory_of_ranks(const double memory, const MPI_Comm communicator)
    {
      const unsigned int n = n_ranks_here(communicator);
      require_memory("command line",
                     "started on " + std::to_string(n) +
                       " ranks on this machine",
                     n * memory,
                     "fewer ranks");
    }
  } // namespace


  template <int dim>
  CampaignStatus
  run_campaign(const Scenarios       &scenarios,
               const CampaignOptions &options,
               const MPI_Comm         communicator)
  {
    const CampaignParameters &parameters = scenarios[0]->reliability.campaign;
    const std::string &folder  = scenarios[0]->simulation.output.directory;
    const CampaignInfo info    = campaign_info(scenarios);
    const int          rank    = Utilities::MPI::this_mpi_process(communicator);
    const int          n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    const auto         last =
      std::min<std::uint64_t>(options.last, parameters.realisations);
    if (options.first >= last)
      throw UserError("command line",
                      "--realisations begins at " +
                        std::to_string(options.first),
                      "numbers from 0 to Campaign/Realisations - 1, " +
                        std::to_string(parameters.realisations - 1));

    // All input is checked before anything is written.
    const RankGroups groups(communicator, parameters.ranks_per_realisation);
    read_level_distribution(scenarios[0]->reliability.analysis.risk);
    if (rank == 0)
      check_campaign_folder(folder, info, options);

    Log log =
      rank == 0 ? Log(std::cout, n_ranks == 1 && Log::is_terminal()) : Log();
    const Runners<dim> runners =
      make_runners<dim>(scenarios, groups.group(), log);
    log.end_progress();
    std::unique_ptr<CampaignWriter> campaign_writer;
    const RunSizes                  sizes = run_sizes(runners[0]->first_case());
    // The case keeps the points that each realisation begins with.
    check_memory_of_ranks(sizes.memory + sizes.all_points, communicator);
    if (options.before_writing && !options.validate_only)
      options.before_writing();
    if (rank == 0 && !options.validate_only)
      {
        PreparedFolder prepared =
          prepare_campaign_folder(folder, info, options);
        campaign_writer = std::move(prepared.writer);
        log.open_file(join_path(folder, log_name(options)),
                      options.resume || options.is_part);
        if (!prepared.warning.empty())
          log.warning(prepared.warning);
      }
    describe_case(runners[0]->first_case(), log);
    for (const std::string &line : runners[0]->properties().description())
      log.line(line);
    for (const std::string &warning : runners[0]->properties().warnings())
      log.warning(warning);
    log.line(campaign_text(info, n_ranks, groups.size()));
    if (options.validate_only)
      {
        log.line(valid_text(folder));
        return CampaignStatus::completed;
      }
    MPI_Barrier(communicator); // the folder is there
    if (rank != 0 && groups.is_first())
      campaign_writer = std::make_unique<CampaignWriter>(folder);

    FolderWatch watch(folder, info.hash, parameters, scenarios.size());
    Progress   &progress = watch.progress;
    if (progress.n_done() > 0)
      log.line("Found " + std::to_string(progress.n_done()) +
               " finished realisations.");
    if (watch.n_damaged() > 0)
      log.line(std::to_string(watch.n_damaged()) +
               " damaged line(s) of journals dropped (waker status says "
               "which); what is missing is computed again.");

    const TaskSetup setup{parameters.seed,
                          parameters.checkpoint_interval,
                          options.chunk,
                          options.n_chunks,
                          options.interrupt,
                          folder};
    Work            work;
    const auto      start = std::chrono::steady_clock::now();
    const bool      finished =
      groups.is_first()
             ? compute_tasks<dim>(
            runners,
            Schedule(scenarios.size(), options.first, last, parameters.batch),
            setup,
            info,
            groups,
            *campaign_writer,
            watch,
            work,
            log)
             : follow_tasks<dim>(runners, setup, groups, work);
    work.wall =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
        .count();

    // Waits for all ranks: then all journals are complete.
    work.n      = Utilities::MPI::sum(work.n, communicator);
    work.busy   = Utilities::MPI::sum(work.busy, communicator);
    work.fields = Utilities::MPI::sum(work.fields, communicator);
    work.wall   = Utilities::MPI::max(work.wall, communicator);
    const bool interrupted =
      Utilities::MPI::max(finished ? 0 : 1, communicator) == 1;
    watch.poll();
    log.end_progress();
    if (work.n > 0)
      log.line(work_text(work, n_ranks));
    log.line(progress_text(progress, info));
    if (interrupted)
      {
        log.line("Interrupted; go on with --resume.");
        return CampaignStatus::interrupted;
      }
    // What one rank sees on a shared disk counts for all.
    int complete = progress.complete() ? 1 : 0;
    MPI_Bcast(&complete, 1, MPI_INT, 0, communicator);
    if (complete == 0)
      {
        log.line("Other parts of the campaign are missing or still at work: "
                 "waker status " +
                 folder);
        return CampaignStatus::completed;
      }

    const bool made = make_snapshots<dim>(
      scenarios, folder, info.hash, options.interrupt, groups);
    const bool done = Utilities::MPI::min(made ? 1 : 0, communicator) == 1;
    int        has_result = 1;
    if (rank == 0)
      has_result = merge_campaign(folder, *scenarios[0], false, log) ? 1 : 0;
    MPI_Bcast(&has_result, 1, MPI_INT, 0, communicator);
    if (!done)
      {
        log.line("Interrupted before all snapshots were made; go on with "
                 "--resume.");
        return CampaignStatus::interrupted;
      }
    if (has_result == 0)
      return CampaignStatus::no_result;
    return CampaignStatus::completed;
  }


  template CampaignStatus
  run_campaign<2>(const Scenarios &, const CampaignOptions &, const MPI_Comm);
  template CampaignStatus
  run_campaign<3>(const Scenarios &, const CampaignOptions &, const MPI_Comm);
} // namespace Waker
