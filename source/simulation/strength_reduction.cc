// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/file_error.h>
#include <waker/base/log.h>
#include <waker/output/files.h>
#include <waker/output/folder_lock.h>
#include <waker/output/output_files.h>
#include <waker/output/output_folder.h>
#include <waker/simulation/attempts.h>
#include <waker/simulation/describe.h>
#include <waker/simulation/factor_report.h>
#include <waker/simulation/judge_trial.h>
#include <waker/simulation/run.h>
#include <waker/simulation/run_to_end.h>
#include <waker/simulation/strengths.h>
#include <waker/simulation/trial_table.h>

#include <cstdio>
#include <iostream>

namespace Waker
{
  namespace
  {
    /// Thrown by nothing but an interrupt: leaves the search, keeps the table.
    struct Interrupted
    {};


    /// Shows how far a trial is.
    template <int dim>
    class TrialWatcher : public Watcher
    {
    public:
      TrialWatcher(const State<dim>  &state,
                   const double       end_time,
                   const double       factor,
                   const std::string &progress,
                   Log               &log)
        : state(state)
        , end_time(end_time)
        , factor(factor)
        , progress(progress)
        , log(log)
      {}

      void
      advanced() override
      {
        if (!log.progress_due())
          return;
        char text[120];
        std::snprintf(text,
                      sizeof text,
                      "%s, factor %.4f, t = %.2f s, ",
                      progress.c_str(),
                      factor,
                      state.time);
        log.progress(state.time / end_time,
                     text + geometry_text(state.failure));
      }

    private:
      const State<dim>  &state;
      const double       end_time;
      const double       factor;
      const std::string &progress;
      Log               &log;
    };


    /// @param first state at t = 0, strengths not yet divided
    template <int dim>
    Trial
    try_factor(const Case<dim>   &the_case,
               const State<dim>  &first,
               const double       factor,
               const std::string &progress,
               const RunOptions  &options,
               Log               &log)
    {
      State<dim> state = first;
      divide_strengths(the_case.materials, factor, state.points);
      Realisation<dim>  realisation(the_case, state);
      TrialWatcher<dim> watcher(
        state, the_case.parameters.time.end_time, factor, progress, log);
      if (run_to_end(realisation, watcher, options.interrupt) ==
          StopReason::none)
        throw Interrupted();
      log.end_progress();
      return judge_trial(state.failure,
                         realisation.unrest(),
                         the_case.parameters.strength_reduction,
                         state.time);
    }


    /// As in a campaign: with half the time step if it fails numerically, until
    /// the attempts are used up.
    template <int dim>
    Trial
    try_factor(Attempts<dim>     &cases,
               const State<dim>  &first,
               const double       factor,
               const std::string &progress,
               const RunOptions  &options,
               Log               &log)
    {
      Trial trial;
      trial.attempts =
        1 + cases.until_it_works([&](const Case<dim>   &the_case,
                                     const unsigned int attempt) {
          try
            {
              trial =
                try_factor(the_case, first, factor, progress, options, log);
              return true;
            }
          catch (const NumericalFailure &failure)
            {
              log.end_progress();
              log.line("  factor " + std::to_string(factor) + ", attempt " +
                       std::to_string(attempt + 1) +
                       ": numerical failure: " + failure.what());
              return false;
            }
        });
      return trial;
    }


    template <int dim>
    RunStatus
    search(Attempts<dim>     &cases,
           const State<dim>  &first,
           const RunOptions  &options,
           const std::string &strengths,
           TrialTable        &table,
           Log               &log)
    {
      const Parameters                  &parameters = cases.first().parameters;
      const StrengthReductionParameters &p = parameters.strength_reduction;
      FactorSearch search(p.lower_factor, p.upper_factor, p.tolerance);
      unsigned int n_done = 0;
      while (const std::optional<double> factor = search.next())
        {
          const bool known = table.find(*factor) != nullptr;
          if (!known)
            table.add(*factor,
                      try_factor(cases,
                                 first,
                                 *factor,
                                 "trial " + std::to_string(n_done + 1) +
                                   " of about " +
                                   std::to_string(n_done + search.n_left()),
                                 options,
                                 log));
          ++n_done;
          const Trial &trial = *table.find(*factor);
          log.line("  " + describe_trial(*factor, trial) +
                   (known ? ", known" : ""));
          search.add(trial.result);
        }

      write_file(file_path(parameters.output.directory,
                           OutputFile::strength_result),
                 search_json(search, table, strengths, parameters.hash));
      log.line(search_conclusion(search, table));
      for (const double factor : search.undecided())
        if (table.find(factor)->failed_numerically())
          return RunStatus::numerical_failure;
      return RunStatus::completed;
    }
  } // namespace


  template <int dim>
  RunStatus
  run_strength_reduction(const Parameters             &given,
                         const RunOptions             &options,
                         const MPI_Comm                communicator,
                         const StrengthsToReduce<dim> &strengths)
  {
    Parameters parameters              = given;
    parameters.stop.on_initial_failure = true;
    parameters.stop.reading            = parameters.strength_reduction.reading;

    const std::string &directory = parameters.output.directory;
    const FolderMode   mode      = folder_mode(options);
    if (!options.validate_only)
      refuse_campaign_folder(directory);
    check_output_folder(directory, mode);
    if (!options.validate_only)
      refuse_locked_folder(directory);
    Log           log(std::cout, Log::is_terminal());
    Attempts<dim> cases(parameters,
                        strengths.attempts,
                        communicator,
                        initial_stress_progress(parameters.initial_stress,
                                                log));
    log.end_progress();
    const Case<dim>               &the_case = cases.first();
    const std::vector<std::string> reduced =
      described_strengths(the_case.materials, parameters.materials);
    State<dim>               first = initial_state(the_case);
    std::vector<std::string> setup_lines;
    if (strengths.setup)
      setup_lines = strengths.setup(the_case, first);

    const std::vector<std::string> kept     = kept_walls(parameters.walls);
    const auto                     describe = [&]() {
      describe_case(the_case, log);
      for (const std::vector<std::string> &lines : {reduced, kept, setup_lines})
        for (const std::string &line : lines)
          log.line(line);
      log.line("Strengths: " + strengths.name + ".");
    };
    if (options.validate_only)
      {
        describe();
        log.line(valid_text(directory));
        return RunStatus::completed;
      }
    if (options.before_writing)
      options.before_writing();
    // A table that does not fit is refused before anything is written.
    const std::string key =
      (strengths.key.empty() ? parameters.hash + ", to " +
                                 std::to_string(parameters.time.end_time) + " s"
                             : strengths.key) +
      ", strengths: " + strengths.name +
      ", reading: " + name_of(parameters.strength_reduction.reading);
    const FolderLock lock = lock_folder(directory, "waker strength-reduction");
    TrialTable       table(directory, key, options.resume);
    prepare_output_folder(directory, mode, parameters.text);
    table.write();
    log.open_file(file_path(directory, OutputFile::log), options.resume);
    if (table.n_damaged() > 0)
      log.line(std::to_string(table.n_damaged()) + " damaged line(s) of " +
               file_name(OutputFile::strength_table) +
               " dropped; their trials are made again.");
    describe();
    try
      {
        return search(cases, first, options, strengths.name, table, log);
      }
    catch (const Interrupted &)
      {
        log.end_progress();
        log.line("Interrupted; the trials made are kept, go on with --resume.");
        return RunStatus::interrupted;
      }
  }


  template RunStatus
  run_strength_reduction(const Parameters &,
                         const RunOptions &,
                         const MPI_Comm,
                         const StrengthsToReduce<2> &);
  template RunStatus
  run_strength_reduction(const Parameters &,
                         const RunOptions &,
                         const MPI_Comm,
                         const StrengthsToReduce<3> &);
} // namespace Waker
