// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/hash.h>
#include <waker/base/log.h>
#include <waker/output/files.h>
#include <waker/output/summary.h>
#include <waker/reliability/campaign_folder.h>
#include <waker/reliability/intervals.h>
#include <waker/reliability/journal.h>
#include <waker/reliability/progress.h>
#include <waker/reliability/realisation_runner.h>
#include <waker/reliability/report.h>
#include <waker/reliability/schedule.h>
#include <waker/reliability/snapshots.h>
#include <waker/simulation/describe.h>

#include <chrono>
#include <cstdio>
#include <iostream>
#include <optional>

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
        if (input.simulation.water.side != "none")
          scenario.water_level = input.simulation.water.level;
        for (const LayerParameters &layer : input.simulation.layers)
          for (const auto &corner : layer.corners())
            scenario.crest_level = std::max(scenario.crest_level, corner[1]);
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
    /// "12.3 s", "4.5 min", "2.1 h"
    std::string
    duration(const double seconds)
    {
      char text[40];
      if (seconds < 100.)
        std::snprintf(text, sizeof text, "%.1f s", seconds);
      else if (seconds < 6000.)
        std::snprintf(text, sizeof text, "%.1f min", seconds / 60.);
      else
        std::snprintf(text, sizeof text, "%.1f h", seconds / 3600.);
      return text;
    }


    /// "120 of 200 done, 14 failed, 10 flooded, P(F) = 0.083 [0.041, 0.148]"
    std::string
    progress_text(const Progress &progress, const unsigned int n_scenarios)
    {
      Counts sum;
      for (unsigned int s = 0; s < n_scenarios; ++s)
        {
          sum.n += progress.counts(s).n;
          sum.n_failures += progress.counts(s).n_failures;
          sum.n_initial += progress.counts(s).n_initial;
          sum.n_flooding += progress.counts(s).n_flooding;
        }
      char text[200];
      int  length =
        std::snprintf(text,
                      sizeof text,
                      "%llu of %llu, S1 %llu, flooded %llu",
                      static_cast<unsigned long long>(sum.n),
                      static_cast<unsigned long long>(progress.n_wanted()),
                      static_cast<unsigned long long>(sum.n_initial),
                      static_cast<unsigned long long>(sum.n_flooding));
      if (sum.n_failures > 0)
        length +=
          std::snprintf(text + length,
                        sizeof text - length,
                        ", numerical failures %llu",
                        static_cast<unsigned long long>(sum.n_failures));
      if (n_scenarios == 1 && sum.n > sum.n_failures)
        {
          const Interval interval =
            clopper_pearson(sum.n_flooding, sum.n - sum.n_failures);
          std::snprintf(text + length,
                        sizeof text - length,
                        ", P(F) = %.3g [%.3g, %.3g]",
                        double(sum.n_flooding) / (sum.n - sum.n_failures),
                        interval.low,
                        interval.high);
        }
      return text;
    }


    std::string
    log_name(const CampaignOptions &options)
    {
      if (options.n_chunks > 1)
        return "log-" + std::to_string(options.chunk) + "-of-" +
               std::to_string(options.n_chunks) + ".txt";
      if (options.is_part)
        return "log-from-" + std::to_string(options.first) + ".txt";
      return "log.txt";
    }


    template <int dim>
    void
    describe(const RealisationRunner<dim> &runner,
             const CampaignInfo           &info,
             const int                     n_ranks,
             Log                          &log)
    {
      describe_case(runner.first_case(), log);
      for (const std::string &line : runner.properties().description())
        log.line(line);
      log.line("Campaign " + info.hash + ": " +
               std::to_string(info.scenarios.size()) +
               " scenario(s) of up to " + std::to_string(info.realisations) +
               " realisations, seed " + std::to_string(info.seed) + ", " +
               std::to_string(n_ranks) + " rank(s)");
      if (!info.swept_parameter.empty())
        for (const ScenarioInfo &scenario : info.scenarios)
          log.line("  " + info.swept_parameter + " = " + scenario.value);
    }


    /// Collects what the journals of the folder say.
    class FolderWatch
    {
    public:
      FolderWatch(const std::string        &folder,
                  const std::string        &hash,
                  const CampaignParameters &parameters,
                  const unsigned int        n_scenarios)
        : progress(parameters, n_scenarios)
        , reader(folder, hash)
      {
        poll();
      }

      void
      poll()
      {
        for (const Record &record : reader.poll())
          progress.add(record);
      }

      Progress progress;

    private:
      JournalReader reader;
    };
  } // namespace


  template <int dim>
  CampaignStatus
  run_campaign(const Scenarios       &scenarios,
               const CampaignOptions &options,
               const MPI_Comm         communicator)
  {
    using Clock                          = std::chrono::steady_clock;
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
    read_level_distribution(scenarios[0]->reliability.analysis.risk);
    if (rank == 0)
      check_campaign_folder(folder, info, options);
    std::vector<std::unique_ptr<RealisationRunner<dim>>> runners;
    for (const auto &scenario : scenarios)
      runners.push_back(
        std::make_unique<RealisationRunner<dim>>(scenario->simulation,
                                                 scenario->reliability.fields,
                                                 parameters.attempts,
                                                 MPI_COMM_SELF));

    Log log =
      rank == 0 ? Log(std::cout, n_ranks == 1 && Log::is_terminal()) : Log();
    if (options.validate_only)
      {
        describe(*runners[0], info, n_ranks, log);
        log.line("Valid. Nothing was written.");
        return CampaignStatus::completed;
      }
    if (rank == 0)
      {
        prepare_campaign_folder(folder, info, options);
        log.open_file(join_path(folder, log_name(options)),
                      options.resume || options.is_part);
        describe(*runners[0], info, n_ranks, log);
      }
    MPI_Barrier(communicator);

    FolderWatch watch(folder, info.hash, parameters, scenarios.size());
    Progress   &progress = watch.progress;
    if (progress.n_done() > 0)
      log.line("Found " + std::to_string(progress.n_done()) +
               " finished realisations.");

    const Schedule               schedule(scenarios.size(),
                            options.first,
                            last,
                            parameters.batch);
    IndexCounter                 counter(communicator);
    std::optional<JournalWriter> writer;
    std::uint64_t                n_own = 0, batch = -1;
    double                       busy        = 0.; // s
    const auto                   start       = Clock::now();
    bool                         interrupted = false;
    while (true)
      {
        const std::uint64_t number =
          counter.next() * options.n_chunks + options.chunk - 1;
        if (number >= schedule.size())
          break;
        const Task task = schedule.task(number);
        if (task.batch != batch)
          {
            watch.poll();
            batch = task.batch;
          }
        if (task.realisation >= progress.end(task.scenario) ||
            progress.is_done(task.scenario, task.realisation))
          continue;

        std::optional<Record> record =
          runners[task.scenario]->run(parameters.seed,
                                      task.realisation,
                                      options.interrupt);
        if (!record)
          {
            interrupted = true;
            break;
          }
        record->scenario = task.scenario;
        if (!writer)
          writer.emplace(folder, info.hash);
        writer->append(*record);
        progress.add(*record);
        ++n_own;
        busy += record->wall_time;

        if (rank == 0 && log.progress_due())
          {
            watch.poll();
            log.progress(double(progress.n_done()) / progress.n_wanted(),
                         progress_text(progress, scenarios.size()));
          }
      }

    const double wall =
      std::chrono::duration<double>(Clock::now() - start).count();
    n_own = Utilities::MPI::sum(n_own, communicator); // waits for all ranks
    busy  = Utilities::MPI::sum(busy, communicator);
    interrupted = Utilities::MPI::max(interrupted ? 1 : 0, communicator) != 0;
    const double slowest = Utilities::MPI::max(wall, communicator);
    watch.poll();
    log.end_progress();
    if (n_own > 0)
      {
        char text[200];
        std::snprintf(text,
                      sizeof text,
                      "%llu realisations in %s on %d rank(s): %.0f an hour and "
                      "core; ranks busy %.1f %%",
                      static_cast<unsigned long long>(n_own),
                      duration(slowest).c_str(),
                      n_ranks,
                      n_own / (slowest * n_ranks) * 3600.,
                      100. * busy / (slowest * n_ranks));
        log.line(text);
      }
    log.line(progress_text(progress, scenarios.size()));
    if (interrupted)
      {
        log.line("Interrupted; go on with --resume.");
        return CampaignStatus::interrupted;
      }
    if (!progress.complete())
      {
        log.line("Other parts of the campaign are missing or still at work: "
                 "waker status " +
                 folder);
        return CampaignStatus::completed;
      }

    const bool done = make_snapshots<dim>(
      scenarios, folder, info.hash, progress, options.interrupt, communicator);
    if (rank == 0)
      merge_campaign(folder, *scenarios[0], false, log);
    return done ? CampaignStatus::completed : CampaignStatus::interrupted;
  }


  template CampaignStatus
  run_campaign<2>(const Scenarios &, const CampaignOptions &, const MPI_Comm);
  template CampaignStatus
  run_campaign<3>(const Scenarios &, const CampaignOptions &, const MPI_Comm);
} // namespace Waker
