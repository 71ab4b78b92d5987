// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/log.h>
#include <waker/base/version.h>
#include <waker/output/files.h>
#include <waker/output/output_folder.h>
#include <waker/simulation/describe.h>
#include <waker/simulation/realisation.h>
#include <waker/simulation/run.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// The realisation at one factor, as a line of the table.
    struct Trial
    {
      bool        failed  = false;
      double      time    = 0.; // of failure, or of the end, s
      std::string outcome = "interrupted";
    };

    const char *const table_name = "strength_reduction.csv";


    /// Thrown by nothing but an interrupt: leaves the search, keeps the table.
    struct Interrupted
    {};


    /**
     * The trials made so far, on disk line by line: an interrupted search goes
     * on where it was.
     */
    class Table
    {
    public:
      /// @param key of the case: the trials of another one are refused
      Table(const std::string &path, const std::string &key, const bool resume)
        : path(path)
        , key(key)
      {
        if (resume)
          read();
        std::ofstream file(path);
        file << "# parameters " << key << "\nfactor,failed,time_s,outcome\n";
        for (const auto &[factor, trial] : trials)
          write_line(file, factor, trial);
      }

      const Trial *
      find(const double factor) const
      {
        const auto it = trials.find(factor);
        return it != trials.end() ? &it->second : nullptr;
      }

      void
      add(const double factor, const Trial &trial)
      {
        trials[factor] = trial;
        std::ofstream file(path, std::ios::app);
        write_line(file, factor, trial);
      }

      std::size_t
      size() const
      {
        return trials.size();
      }

    private:
      void
      read()
      {
        std::ifstream file(path);
        std::string   line;
        if (std::getline(file, line) && line != "# parameters " + key)
          throw UserError("Output/Directory",
                          path + " belongs to another case",
                          "--resume with the parameters it was made with, or "
                          "--overwrite");
        std::getline(file, line); // header
        while (std::getline(file, line))
          {
            double factor, time;
            int    failed;
            char   outcome[64];
            if (std::sscanf(line.c_str(),
                            "%lf,%d,%lf,%63[^,\n]",
                            &factor,
                            &failed,
                            &time,
                            outcome) == 4)
              trials[factor] = {failed != 0, time, outcome};
          }
      }

      static void
      write_line(std::ostream &out, const double factor, const Trial &trial)
      {
        char text[160];
        std::snprintf(text,
                      sizeof text,
                      "%.17g,%d,%.10g,%s\n",
                      factor,
                      trial.failed ? 1 : 0,
                      trial.time,
                      trial.outcome.c_str());
        out << text << std::flush;
      }

      std::string             path;
      std::string             key;
      std::map<double, Trial> trials;
    };


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
           Table            &table,
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
      write_file(join_path(the_case.parameters.output.directory,
                           "strength_reduction.json"),
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
    const std::string path = join_path(directory, table_name);
    const std::string key  = parameters.hash + ", to " +
                            std::to_string(parameters.time.end_time) + " s";
    std::unique_ptr<Table> table;
    if (options.resume)
      table = std::make_unique<Table>(path, key, true);
    prepare_output_folder(directory, mode, parameters.text);
    if (!options.resume)
      table = std::make_unique<Table>(path, key, false);
    log.open_file(join_path(directory, "log.txt"), options.resume);
    try
      {
        return search(the_case, options, *table, log);
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
