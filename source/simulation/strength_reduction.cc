// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/log.h>
#include <waker/base/version.h>
#include <waker/output/files.h>
#include <waker/output/folder_lock.h>
#include <waker/output/output_files.h>
#include <waker/output/output_folder.h>
#include <waker/simulation/describe.h>
#include <waker/simulation/realisation.h>
#include <waker/simulation/run.h>
#include <waker/simulation/trial_table.h>

#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// Thrown by nothing but an interrupt: leaves the search, keeps the table.
    struct Interrupted
    {};


    template <int dim>
    Trial
    try_factor(const Case<dim>  &the_case,
               const double      factor,
               const RunOptions &options,
               Log              &log)
    {
      State<dim> state = initial_state(the_case);
      for (const char *const name :
           {"undrained shear strength", "residual strength"})
        for (double &strength : state.points.scalar(name))
          strength /= factor;

      Realisation<dim> realisation(the_case, state);
      Trial            trial;
      while (realisation.look() == StopReason::none)
        {
          if (options.interrupt != nullptr && *options.interrupt != 0)
            throw Interrupted();
          realisation.advance();
          if (log.progress_due())
            {
              char text[80];
              std::snprintf(text,
                            sizeof text,
                            "factor %.4f, t = %.2f s, W = %.2f m",
                            factor,
                            state.time,
                            state.failure.geometry.width);
              log.progress(state.time / the_case.parameters.time.end_time,
                           text);
            }
        }
      log.end_progress();
      const double failure_time =
        state.failure.time_of(the_case.parameters.stop.reading);
      trial.failed = failure_time >= 0.;
      trial.time   = trial.failed ? failure_time : state.time;
      trial.outcome =
        to_string(outcome_of(state.failure, realisation.unrest()));
      if (!state.failure.slope().empty())
        trial.outcome += " (" + state.failure.slope() + " slope)";
      return trial;
    }


    template <int dim>
    RunStatus
    search(const Case<dim>  &the_case,
           const RunOptions &options,
           TrialTable       &table,
           Log              &log)
    {
      const StrengthReductionParameters &p =
        the_case.parameters.strength_reduction;
      const auto fails = [&](const double factor) {
        const bool known = table.find(factor) != nullptr;
        if (!known)
          table.add(factor, try_factor(the_case, factor, options, log));
        const Trial &trial = *table.find(factor);
        char         text[160];
        std::snprintf(text,
                      sizeof text,
                      "  factor %.4f: %s at t = %.2f s (%s)%s",
                      factor,
                      trial.failed ? "fails " : "stable",
                      trial.time,
                      trial.outcome.c_str(),
                      known ? ", known" : "");
        log.line(text);
        return trial.failed;
      };

      double     stable = p.lower_factor, failed = p.upper_factor;
      const bool lower_fails = fails(stable);
      const bool upper_fails = lower_fails || fails(failed);
      const bool has_bracket = !lower_fails && upper_fails;
      while (has_bracket && failed - stable > p.tolerance)
        {
          const double middle               = 0.5 * (stable + failed);
          (fails(middle) ? failed : stable) = middle;
        }

      nlohmann::ordered_json json;
      json["schema_version"] = 1;
      json["factor_of_safety"] =
        has_bracket ? nlohmann::ordered_json(0.5 * (stable + failed))
                    : nlohmann::ordered_json();
      json["highest_stable_factor"] =
        lower_fails ? nlohmann::ordered_json()
                    : nlohmann::ordered_json(upper_fails ? stable : failed);
      json["lowest_failed_factor"] =
        lower_fails   ? nlohmann::ordered_json(stable)
        : upper_fails ? nlohmann::ordered_json(failed)
                      : nlohmann::ordered_json();
      json["trials"]          = table.size();
      json["parameters_hash"] = the_case.parameters.hash;
      json["version"]         = WAKER_VERSION;
      write_file(file_path(the_case.parameters.output.directory,
                           OutputFile::strength_result),
                 json.dump(2) + "\n");

      std::ostringstream text;
      if (has_bracket)
        text << "Factor of safety: " << 0.5 * (stable + failed)
             << " (stable at " << stable << ", fails at " << failed << ", "
             << table.size() << " trials)";
      else if (lower_fails)
        text << "Fails at the lower factor " << stable
             << " already: lower \"Strength reduction/Lower factor\".";
      else
        text << "Stable at the upper factor " << failed
             << " still: raise \"Strength reduction/Upper factor\".";
      log.line(text.str());
      return RunStatus::completed;
    }
  } // namespace


  template <int dim>
  RunStatus
  run_strength_reduction(const Parameters &given,
                         const RunOptions &options,
                         const MPI_Comm    communicator)
  {
    Parameters parameters              = given;
    parameters.stop.on_initial_failure = true;
    parameters.stop.reading = parameters.strength_reduction.failure_reading();

    const std::string &directory = parameters.output.directory;
    const FolderMode   mode      = options.resume      ? FolderMode::resume
                                   : options.overwrite ? FolderMode::overwrite
                                                       : FolderMode::must_be_new;
    refuse_campaign_folder(parameters.output.directory);
    check_output_folder(directory, mode);
    if (!options.validate_only)
      refuse_locked_folder(directory);
    const Case<dim> the_case(parameters, communicator);
    if (the_case.initial_points.find_scalar("undrained shear strength") < 0)
      throw UserError("Materials/Names",
                      "no material has an undrained shear strength to reduce",
                      "a \"von Mises softening\" material");
    Log log(std::cout, Log::is_terminal());
    describe_case(the_case, log);
    if (options.validate_only)
      {
        log.line("Valid. Nothing was written.");
        return RunStatus::completed;
      }
    // The end time belongs to a trial, though not to the hash. A table that
    // does not fit is refused before anything is written.
    const std::string key = parameters.hash + ", to " +
                            std::to_string(parameters.time.end_time) + " s";
    const FolderLock lock = lock_folder(directory, "waker strength-reduction");
    TrialTable       table(directory, key, options.resume);
    prepare_output_folder(directory, mode, parameters.text);
    table.write();
    log.open_file(file_path(directory, OutputFile::log), options.resume);
    if (table.n_damaged() > 0)
      log.line(std::to_string(table.n_damaged()) + " damaged line(s) of " +
               file_name(OutputFile::strength_table) +
               " dropped; their trials are made again.");
    try
      {
        return search(the_case, options, table, log);
      }
    catch (const Interrupted &)
      {
        log.line("Interrupted; the trials made are kept, go on with --resume.");
        return RunStatus::interrupted;
      }
    catch (const NumericalFailure &failure)
      {
        log.line(std::string("Numerical failure: ") + failure.what());
        return RunStatus::numerical_failure;
      }
  }


  template RunStatus
  run_strength_reduction<2>(const Parameters &,
                            const RunOptions &,
                            const MPI_Comm);
  template RunStatus
  run_strength_reduction<3>(const Parameters &,
                            const RunOptions &,
                            const MPI_Comm);
} // namespace Waker
