// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/mpi.h>

#include <waker/base/errors.h>
#include <waker/campaign/campaign.h>
#include <waker/campaign/snapshots.h>
#include <waker/campaign/strength_reduction.h>
#include <waker/program/compute.h>
#include <waker/program/exit_codes.h>
#include <waker/program/parameter_reader.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <signal.h>
#include <thread>
#include <unistd.h>

namespace Waker
{
  namespace
  {
    /// The signal that asked the run to end, or 0. A handler can reach no
    /// other memory; the run sees it through RunOptions only.
    volatile std::sig_atomic_t received_signal = 0;
    /// Is there something to leave whole?
    volatile std::sig_atomic_t something_is_written = 0;


    /// Before anything is written a signal ends the program at once: reading
    /// and setting up may take minutes, part of them in libraries. Afterwards
    /// the run leaves its files whole.
    extern "C" void
    note_signal(int signal)
    {
      if (something_is_written == 0)
        _exit(signal_offset + signal);
      received_signal = signal;
    }


    void
    obey_signals()
    {
      struct sigaction action = {};
      action.sa_handler       = note_signal;
      sigemptyset(&action.sa_mask);
      // The second one ends at once. No SA_RESTART: a call of the system that
      // waits (for another host's disk, say) ends, too.
      action.sa_flags = SA_RESETHAND;
      sigaction(SIGINT, &action, nullptr);
      sigaction(SIGTERM, &action, nullptr);
    }


    void
    begin_writing()
    {
      something_is_written = 1;
    }


    /// Starting MPI alone is faster when it need not look for other ranks
    /// (0.35 instead of 0.6 s). What the user has set stays.
    void
    prepare_single_rank()
    {
      for (const char *const launcher :
           {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"})
        if (std::getenv(launcher) != nullptr)
          return;
      setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
      // Its folders have one name for all lone processes, which end at times of
      // their own and remove them.
      setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
      setenv("OMPI_MCA_btl", "self", 0);
      setenv("OMPI_MCA_pml", "ob1", 0);
    }



    unsigned int
    n_ranks()
    {
      return Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    }


    int
    exit_code(const RunStatus status)
    {
      switch (status)
        {
          case RunStatus::completed:
            return success;
          case RunStatus::numerical_failure:
            return numerical_failure;
          case RunStatus::interrupted:
            {
              // All ranks are here, and one of them has it at least.
              const int mine   = received_signal;
              const int signal = Utilities::MPI::max(mine, MPI_COMM_WORLD);
              return signal_offset + (signal != 0 ? signal : SIGINT);
            }
        }
      return internal_error;
    }


    /// With random fields Output/Directory is where the campaign is, so what
    /// else is computed goes beside it, unless the command line says where.
    std::string
    single_folder(const CommandLine &line, const Input &input)
    {
      const std::string &directory = input.simulation.output.directory;
      for (const std::string &text : line.overrides)
        if (text.rfind("Output/Directory", 0) == 0)
          return directory;
      const bool is_random = !input.reliability.fields.fields.empty();
      return directory +
             (input.reliability.sweep.parameter.empty()
                ? ""
                : "-scenario-" + std::to_string(line.scenario)) +
             (line.realisation
                ? "-realisation-" + std::to_string(*line.realisation)
                : "") +
             (line.command == Command::strength_reduction && is_random
                ? "-strength-reduction"
                : "");
    }


    /// One realisation, or a strength reduction.
    template <int dim>
    int
    run_one(const CommandLine &line, const Input &input)
    {
      if (n_ranks() > 1 && line.command == Command::strength_reduction)
        throw UserError("command line",
                        "a strength reduction is started on " +
                          std::to_string(n_ranks()) + " ranks",
                        "one rank for it, for now");
      RunOptions options;
      options.validate_only  = line.validate_only;
      options.resume         = line.resume;
      options.overwrite      = line.overwrite;
      options.interrupt      = &received_signal;
      options.before_writing = begin_writing;

      const bool is_random = !input.reliability.fields.fields.empty();
      if (!is_random && line.realisation)
        throw UserError("command line",
                        "--realisation is given, but nothing is random",
                        "a file with names in Random fields/Names");
      if (line.command == Command::strength_reduction)
        return exit_code(reduce_strengths<dim>(input,
                                               line.realisation,
                                               line.scenario,
                                               single_folder(line, input),
                                               options,
                                               MPI_COMM_WORLD));
      if (is_random && !line.realisation)
        throw UserError("Random fields/Names",
                        "there are random fields, but no --realisation i",
                        "waker run FILE --realisation i, waker campaign FILE, "
                        "or --set \"Random fields/Names=\"" +
                          std::string(
                            input.reliability.fields.correlations.empty()
                              ? ""
                              : " --set \"Random fields/Correlations=\""));
      if (!is_random)
        return exit_code(run<dim>(input.simulation, options, MPI_COMM_WORLD));
      return exit_code(run_realisation<dim>(input,
                                            *line.realisation,
                                            single_folder(line, input),
                                            options,
                                            MPI_COMM_WORLD));
    }


    template <int dim>
    int
    run_many(const CommandLine &line, const Scenarios &scenarios)
    {
      if (scenarios[0]->reliability.fields.fields.empty())
        throw UserError("Random fields/Names",
                        "is empty: all realisations would be the same",
                        "at least one random field");
      CampaignOptions options;
      options.validate_only  = line.validate_only;
      options.resume         = line.resume;
      options.overwrite      = line.overwrite;
      options.is_part        = line.is_part;
      options.chunk          = line.chunk;
      options.n_chunks       = line.n_chunks;
      options.first          = line.first;
      options.last           = line.last;
      options.interrupt      = &received_signal;
      options.before_writing = begin_writing;
      switch (run_campaign<dim>(scenarios, options, MPI_COMM_WORLD))
        {
          case CampaignStatus::completed:
            return exit_code(RunStatus::completed);
          case CampaignStatus::no_result:
            return exit_code(RunStatus::numerical_failure);
          case CampaignStatus::interrupted:
            return exit_code(RunStatus::interrupted);
        }
      return internal_error;
    }


    int
    compute(const CommandLine &line, const Scenarios &scenarios)
    {
      if (line.scenario >= scenarios.size())
        throw UserError("command line",
                        "--scenario is " + std::to_string(line.scenario),
                        "0 to " + std::to_string(scenarios.size() - 1));
      const Input &input = *scenarios[line.scenario];
      const bool   plane = input.simulation.dimension == 2;
      if (line.command == Command::campaign)
        return plane ? run_many<2>(line, scenarios)
                     : run_many<3>(line, scenarios);
      return plane ? run_one<2>(line, input) : run_one<3>(line, input);
    }
  } // namespace


  int
  compute(const CommandLine &line, char **argv)
  {
    obey_signals();
    ParameterLocations locations;
    const Scenarios    scenarios =
      read_scenarios(line.file, line.overrides, &locations);

    // MPI and PETSc would read options that are ours: only the name.
    int    n_arguments = 1;
    char  *name[]      = {argv[0], nullptr};
    char **arguments   = name;
    prepare_single_rank();
    const Utilities::MPI::MPI_InitFinalize mpi(n_arguments, arguments, 1);
    obey_signals(); // MPI and PETSc have handlers of their own
    try
      {
        try
          {
            return compute(line, scenarios);
          }
        catch (const UserError &error)
          {
            throw locations.located(error);
          }
      }
    catch (...)
      {
        if (n_ranks() == 1)
          throw;
        // The first rank meets most errors, too, and says so once for all.
        if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) > 0)
          std::this_thread::sleep_for(std::chrono::seconds(5));
        // The other ranks wait for this one, for ever: end them all.
        MPI_Abort(MPI_COMM_WORLD, report_exception());
        throw;
      }
  }
} // namespace Waker
