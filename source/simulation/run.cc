// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <waker/base/errors.h>
#include <waker/base/file_error.h>
#include <waker/base/log.h>
#include <waker/base/numbers.h>
#include <waker/base/ranks.h>
#include <waker/base/version.h>
#include <waker/mechanics/time_scheme.h>
#include <waker/output/checkpoint.h>
#include <waker/output/files.h>
#include <waker/output/folder_lock.h>
#include <waker/output/output_files.h>
#include <waker/output/output_folder.h>
#include <waker/simulation/describe.h>
#include <waker/simulation/plausibility.h>
#include <waker/simulation/recorder.h>
#include <waker/simulation/run.h>
#include <waker/simulation/run_to_end.h>

#include "end_warnings.h"
#include "follow.h"
#include "run_watcher.h"
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>

namespace Waker
{
  namespace
  {
    /// What was warned of may be why a run has failed numerically.
    void
    repeat_warnings(const RunStatus status, Log &log)
    {
      if (status != RunStatus::numerical_failure || log.warnings().empty())
        return;
      log.line("  It was warned of, and may be why:");
      for (const std::string &text : log.warnings())
        log.line("    " + text);
    }


    template <int dim>
    RunStatus
    loop(Case<dim>        &the_case,
         const RunOptions &options,
         const bool        resumed,
         State<dim>       &state,
         Recorder<dim>    &recorder,
         Log              &log)
    {
      const auto          start      = std::chrono::steady_clock::now();
      const std::uint64_t first_step = state.step;
      Realisation<dim>    realisation(the_case, state);
      RunWatcher<dim>     watcher(
        the_case.parameters, resumed, state, realisation, recorder, log);

      Outcome     outcome = Outcome::numerical_failure;
      Unrest      unrest;
      std::string reason;
      RunStatus   status = RunStatus::completed;
      try
        {
          const StopReason stop =
            run_to_end(realisation, watcher, options.interrupt);
          if (stop == StopReason::none)
            status = RunStatus::interrupted;
          else
            {
              unrest  = realisation.unrest();
              outcome = outcome_of(state.failure, unrest);
              reason  = to_string(stop);
            }
        }
      catch (const UserError &error)
        {
          throw_of_a_begun_run(error, the_case.parameters.output.directory);
        }
      catch (const NumericalFailure &failure)
        {
          reason = failure.what();
          status = RunStatus::numerical_failure;
          // The last good state, as a rule. A step that has left no numbers
          // must not replace what is on disk.
          if (realisation.has_numbers())
            watcher.write_checkpoint();
        }
      log.end_progress();

      const std::chrono::duration<double> wall =
        std::chrono::steady_clock::now() - start;
      if (status == RunStatus::interrupted)
        {
          log.line("Interrupted at t = " + std::to_string(state.time) +
                   " s; go on with --resume.");
          return status;
        }
      warn_at_end(realisation.view(), outcome, log);
      recorder.write_summary(state,
                             the_case.programmes.names(),
                             outcome,
                             unrest,
                             reason,
                             wall.count(),
                             log.warnings());
      describe_traffic(realisation.traffic(),
                       Utilities::MPI::n_mpi_processes(
                         the_case.grid.communicator()),
                       state.step - first_step,
                       log);
      describe_result(state,
                      the_case.programmes.names(),
                      outcome,
                      unrest,
                      reason,
                      wall.count(),
                      state.step - first_step,
                      log);
      repeat_warnings(status, log);
      return status;
    }
  } // namespace


  FolderMode
  folder_mode(const RunOptions &options)
  {
    return options.resume          ? FolderMode::resume
           : options.validate_only ? FolderMode::only_checked
           : options.overwrite     ? FolderMode::overwrite
                                   : FolderMode::must_be_new;
  }


  namespace
  {
    bool
    has_checkpoint(const std::string &directory)
    {
      std::error_code error;
      for (unsigned int slot = 0; slot < CheckpointSlots::n_slots; ++slot)
        if (std::filesystem::exists(join_path(directory, checkpoint_name(slot)),
                                    error))
          return true;
      return false;
    }


    template <int dim>
    RunStatus
    run_in_folder(const Parameters        &parameters,
                  const RunOptions        &options,
                  const MPI_Comm           communicator,
                  const InitialSetup<dim> &setup)
    {
      if (Utilities::MPI::this_mpi_process(communicator) > 0)
        return follow(parameters, options, communicator, setup);
      const auto         start     = std::chrono::steady_clock::now();
      const std::string &directory = parameters.output.directory;
      if (!options.validate_only)
        refuse_campaign_folder(directory);
      check_output_folder(directory, folder_mode(options));
      if (!options.validate_only)
        refuse_locked_folder(directory);
      // Those who start several ranks let them believe in a terminal, wherever
      // it goes.
      Log log =
        options.quiet
          ? Log()
          : Log(std::cout, n_ranks(communicator) == 1 && Log::is_terminal());
      std::unique_ptr<Case<dim>> pointer;
      try
        {
          pointer = std::make_unique<Case<dim>>(
            parameters,
            communicator,
            Materials(),
            initial_stress_progress(parameters.initial_stress, log));
          log.end_progress();
        }
      catch (const NumericalFailure &failure)
        {
          log.end_progress();
          // One of these may be why.
          for (const std::string &text : strange_parameters(parameters))
            log.warning(text);
          log.line(std::string("Numerical failure: ") + failure.what());
          if (!options.validate_only && !options.resume)
            {
              if (options.before_writing)
                options.before_writing();
              const FolderLock lock = lock_folder(directory, "waker run");
              prepare_output_folder(directory,
                                    folder_mode(options),
                                    parameters.text);
              State<dim> unknown; // nothing has been measured
              unknown.failure.initial_width   = nan;
              unknown.failure.geometry.width  = nan;
              unknown.failure.geometry.height = nan;
              const std::chrono::duration<double> wall =
                std::chrono::steady_clock::now() - start;
              Recorder<dim>(parameters)
                .write_summary(unknown,
                               {},
                               Outcome::numerical_failure,
                               Unrest(),
                               failure.what(),
                               wall.count(),
                               log.warnings());
            }
          return RunStatus::numerical_failure;
        }
      Case<dim>               &the_case = *pointer;
      State<dim>               state;
      std::vector<std::string> setup_lines;
      if (setup)
        {
          state       = initial_state(the_case);
          setup_lines = setup(the_case, state);
        }
      const auto describe = [&]() {
        describe_case(the_case, log);
        for (const std::string &line : setup_lines)
          log.line(line);
      };
      if (options.validate_only)
        {
          describe();
          log.line(valid_text(directory));
          return RunStatus::completed;
        }

      if (options.before_writing)
        options.before_writing();
      const FolderLock               lock = lock_folder(directory, "waker run");
      std::unique_ptr<Recorder<dim>> recorder;
      if (options.resume)
        {
          recorder = std::make_unique<Recorder<dim>>(parameters, state);
          share_state(communicator, state);
        }
      prepare_output_folder(directory, folder_mode(options), parameters.text);
      require_shared_folder(communicator, directory);
      if (!options.resume)
        recorder = std::make_unique<Recorder<dim>>(parameters);

      log.open_file(file_path(directory, OutputFile::log), options.resume);
      describe();
      if (options.resume)
        {
          if (!recorder->warning().empty())
            log.warning(recorder->warning());
          log.line("Resumed at t = " + std::to_string(state.time) +
                   " s, step " + std::to_string(state.step) + ".");
        }
      if (setup || options.resume)
        the_case.take_initial_points(); // their memory
      else
        state = initial_state(the_case, the_case.take_initial_points());
      return loop(the_case, options, options.resume, state, *recorder, log);
    }
  } // namespace


  template <int dim>
  RunStatus
  run(const Parameters        &parameters,
      const RunOptions        &options,
      const MPI_Comm           communicator,
      const InitialSetup<dim> &setup)
  {
    try
      {
        return run_in_folder(parameters, options, communicator, setup);
      }
    catch (FileError &error)
      {
        error.can_be_resumed = has_checkpoint(parameters.output.directory);
        throw;
      }
  }


  template RunStatus
  run<2>(const Parameters &,
         const RunOptions &,
         const MPI_Comm,
         const InitialSetup<2> &);
  template RunStatus
  run<3>(const Parameters &,
         const RunOptions &,
         const MPI_Comm,
         const InitialSetup<3> &);
} // namespace Waker
