// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/hash.h>
#include <waker/base/random_numbers.h>
#include <waker/output/files.h>
#include <waker/reliability/journal.h>
#include <waker/reliability/random_properties.h>
#include <waker/reliability/snapshots.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

namespace Waker
{
  template <int dim>
  InitialSetup<dim>
  realisation_setup(const Input &input, const std::uint64_t realisation)
  {
    return [&input, realisation](const Case<dim> &the_case, State<dim> &state) {
      const RandomProperties<dim> properties(the_case,
                                             input.reliability.fields);
      const std::uint64_t         seed = input.reliability.campaign.seed;
      std::vector<double>         noise(properties.n_noise());
      white_noise({seed, realisation, 0}, 0, noise.size(), noise.data());
      properties.apply(noise.data(), state);

      std::vector<std::string> lines = properties.description();
      const auto [mean, least]       = properties.mean_and_least(state);
      char text[160];
      std::snprintf(text,
                    sizeof text,
                    "Realisation %llu of seed %llu: mean %.3f, least %.3f kPa",
                    static_cast<unsigned long long>(realisation),
                    static_cast<unsigned long long>(seed),
                    mean,
                    least);
      lines.push_back(text);
      return lines;
    };
  }


  Parameters
  realisation_parameters(const Input &input, const std::uint64_t realisation)
  {
    Parameters        parameters = input.simulation;
    const std::string which = "realisation " + std::to_string(realisation) +
                              " of seed " +
                              std::to_string(input.reliability.campaign.seed);
    parameters.text = "# " + which + "\n" + parameters.text;
    parameters.hash = hash_of_text(parameters.hash + which);
    return parameters;
  }


  namespace
  {
    /// (scenario, realisation) of those that are asked for.
    std::set<std::pair<unsigned int, std::uint64_t>>
    chosen(const SnapshotParameters  &parameters,
           const std::vector<Record> &records,
           const Progress            &progress)
    {
      std::set<std::pair<unsigned int, std::uint64_t>>         result;
      std::map<std::pair<unsigned int, Outcome>, unsigned int> count;
      for (const Record &record : records) // in order of number
        {
          if (record.realisation >= progress.end(record.scenario))
            continue;
          bool wanted = record.realisation < parameters.first;
          for (const unsigned int number : parameters.realisations)
            wanted = wanted || record.realisation == number;
          if (wanted || count[{record.scenario, record.outcome}]++ <
                          parameters.of_each_outcome)
            result.insert({record.scenario, record.realisation});
        }
      return result;
    }
  } // namespace


  template <int dim>
  bool
  make_snapshots(const Scenarios                  &scenarios,
                 const std::string                &folder,
                 const std::string                &hash,
                 const Progress                   &progress,
                 const volatile std::sig_atomic_t *interrupt,
                 const MPI_Comm                    communicator)
  {
    const SnapshotParameters &wanted = scenarios[0]->reliability.snapshots;
    if (wanted.first == 0 && wanted.of_each_outcome == 0 &&
        wanted.realisations.empty())
      return true;

    unsigned int       number  = 0;
    bool               done    = true;
    const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    for (const auto &[scenario, realisation] :
         chosen(wanted, read_journals(folder, hash).records, progress))
      {
        if (number++ % n_ranks != rank)
          continue;
        const Input &input      = *scenarios[scenario];
        Parameters   parameters = realisation_parameters(input, realisation);
        parameters.output.directory = join_path(join_path(folder, "snapshots"),
                                                std::to_string(scenario) + "-" +
                                                  std::to_string(realisation));
        if (std::filesystem::exists(
              join_path(parameters.output.directory, "summary.json")))
          continue;
        std::filesystem::create_directories(parameters.output.directory);

        RunOptions options;
        options.overwrite = true;
        options.quiet     = true;
        options.interrupt = interrupt;
        if (run<dim>(parameters,
                     options,
                     MPI_COMM_SELF,
                     realisation_setup<dim>(input, realisation)) ==
            RunStatus::interrupted)
          {
            done = false;
            break;
          }
      }
    return Utilities::MPI::min(done ? 1 : 0, communicator) == 1;
  }


  template InitialSetup<2>
  realisation_setup(const Input &, const std::uint64_t);
  template InitialSetup<3>
  realisation_setup(const Input &, const std::uint64_t);
  template bool
  make_snapshots<2>(const Scenarios &,
                    const std::string &,
                    const std::string &,
                    const Progress &,
                    const volatile std::sig_atomic_t *,
                    const MPI_Comm);
  template bool
  make_snapshots<3>(const Scenarios &,
                    const std::string &,
                    const std::string &,
                    const Progress &,
                    const volatile std::sig_atomic_t *,
                    const MPI_Comm);
} // namespace Waker
