// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/hash.h>
#include <waker/campaign/progress.h>
#include <waker/campaign/rank_groups.h>
#include <waker/campaign/realisation_setup.h>
#include <waker/campaign/snapshots.h>
#include <waker/output/files.h>
#include <waker/output/output_files.h>
#include <waker/output/output_folder.h>
#include <waker/simulation/attempts.h>
#include <waker/store/campaign_files.h>
#include <waker/store/journal.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace Waker
{
  namespace fs = std::filesystem;

  namespace
  {
    /// "realisation 17 of seed 1, attempt 2": what tells a run from others of
    /// the same parameters.
    std::string
    title(const Input        &input,
          const std::uint64_t realisation,
          const unsigned int  attempt)
    {
      return realisation_title(input, realisation) + ", attempt " +
             std::to_string(attempt + 1);
    }


    Parameters
    run_parameters(const Input        &input,
                   const std::uint64_t realisation,
                   const unsigned int  attempt,
                   const std::string  &directory)
    {
      Parameters        parameters = input.simulation;
      const std::string name       = title(input, realisation, attempt);
      parameters.text              = "# " + name + "\n" + parameters.text;
      parameters.hash              = hash_of_text(parameters.hash + name);
      parameters.output.directory  = directory;
      parameters.time.time_step =
        time_step_of_attempt(parameters.time.time_step, attempt);
      return parameters;
    }


    /// The attempt whose run is in the folder; 0 if none is.
    unsigned int
    attempt_in_folder(const Input        &input,
                      const std::uint64_t realisation,
                      const std::string  &directory)
    {
      const std::string path = file_path(directory, OutputFile::parameters);
      std::error_code   error;
      if (!fs::exists(path, error))
        return 0;
      const std::string text = read_file(path);
      for (unsigned int a = 1; a < input.reliability.campaign.attempts; ++a)
        if (text.rfind("# " + title(input, realisation, a) + "\n", 0) == 0)
          return a;
      return 0;
    }
  } // namespace


  template <int dim>
  RunStatus
  run_realisation(const Input        &input,
                  const std::uint64_t realisation,
                  const std::string  &directory,
                  const RunOptions   &given_options,
                  const MPI_Comm      communicator)
  {
    RunOptions         options = given_options;
    RunStatus          status  = RunStatus::completed;
    const unsigned int first =
      options.resume ? attempt_in_folder(input, realisation, directory) : 0;
    attempt_until_it_works(
      first,
      input.reliability.campaign.attempts,
      [&](const unsigned int attempt) {
        status =
          run<dim>(run_parameters(input, realisation, attempt, directory),
                   options,
                   communicator,
                   realisation_setup<dim>(input,
                                          realisation,
                                          title(input, realisation, attempt)));
        options.resume    = false;
        options.overwrite = true;
        return status != RunStatus::numerical_failure || options.validate_only;
      });
    return status;
  }


  namespace
  {
    using Choice = std::set<std::pair<unsigned int, std::uint64_t>>;

    /// (scenario, realisation) of those that are asked for.
    Choice
    chosen(const Scenarios           &scenarios,
           const std::vector<Record> &records) // in order of number
    {
      const SnapshotParameters &parameters =
        scenarios[0]->reliability.snapshots;
      Progress progress(scenarios[0]->reliability.campaign, scenarios.size());
      for (const Record &record : records)
        progress.add(record);

      Choice                                                   result;
      std::map<std::pair<unsigned int, Outcome>, unsigned int> count;
      for (const Record &record : records)
        {
          if (record.realisation >= progress.end(record.scenario))
            continue;
          const unsigned int before =
            count[{record.scenario, record.outcome}]++;
          bool wanted = record.realisation < parameters.first ||
                        before < parameters.of_each_outcome;
          for (const unsigned int number : parameters.realisations)
            wanted = wanted || record.realisation == number;
          if (wanted)
            result.insert({record.scenario, record.realisation});
        }
      return result;
    }


    /// By the ranks of a group, of which the first writes it.
    /// @return false if interrupted
    template <int dim>
    bool
    make_snapshot(const Input        &input,
                  const std::uint64_t realisation,
                  const fs::path     &snapshots,
                  const std::string  &name,
                  const Interrupt    &interrupt,
                  const RankGroups   &groups)
    {
      // Under another name until it is whole: another part of the campaign may
      // be making it, too.
      const fs::path unfinished = snapshots / unfinished_name(name);
      RunOptions     options;
      options.overwrite = true;
      options.quiet     = true;
      options.interrupt = interrupt;
      const bool done =
        run_realisation<dim>(input,
                             realisation,
                             unfinished.string(),
                             options,
                             groups.group()) != RunStatus::interrupted;
      if (!groups.is_first())
        return done;
      std::error_code error;
      if (done)
        fs::rename(unfinished, snapshots / name, error);
      if (!done || error)
        remove_run_folder(unfinished.string());
      return done;
    }
  } // namespace


  template <int dim>
  bool
  make_snapshots(const Scenarios   &scenarios,
                 const std::string &folder,
                 const std::string &hash,
                 const Interrupt   &interrupt,
                 const RankGroups  &groups)
  {
    const SnapshotParameters &wanted = scenarios[0]->reliability.snapshots;
    if (wanted.first == 0 && wanted.of_each_outcome == 0 &&
        wanted.realisations.empty())
      return true;

    const fs::path snapshots = snapshots_folder(folder);
    const auto     make      = [&](const Task &task) {
      return make_snapshot<dim>(*scenarios[task.scenario],
                                task.realisation,
                                snapshots,
                                snapshot_name(task.scenario, task.realisation),
                                interrupt,
                                groups);
    };
    if (!groups.is_first())
      {
        while (const std::optional<Task> task = groups.share())
          if (!make(*task))
            return false;
        return true;
      }
    make_folder(snapshots);
    unsigned int number = 0;
    for (const auto &[scenario, realisation] :
         chosen(scenarios, read_journals(folder, hash).records))
      {
        std::error_code error;
        if (number++ % groups.n_groups() != groups.number() ||
            fs::exists(snapshots / snapshot_name(scenario, realisation), error))
          continue;
        const Task task{scenario, realisation, 0};
        groups.share(task);
        if (!make(task))
          return false; // which the others of the group see, too
      }
    groups.share({}); // nothing more
    return true;
  }


  template RunStatus
  run_realisation<2>(const Input &,
                     const std::uint64_t,
                     const std::string &,
                     const RunOptions &,
                     const MPI_Comm);
  template RunStatus
  run_realisation<3>(const Input &,
                     const std::uint64_t,
                     const std::string &,
                     const RunOptions &,
                     const MPI_Comm);
  template bool
  make_snapshots<2>(const Scenarios &,
                    const std::string &,
                    const std::string &,
                    const Interrupt &,
                    const RankGroups &);
  template bool
  make_snapshots<3>(const Scenarios &,
                    const std::string &,
                    const std::string &,
                    const Interrupt &,
                    const RankGroups &);
} // namespace Waker
