// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <waker/base/errors.h>
#include <waker/base/log.h>
#include <waker/output/files.h>
#include <waker/program/command_line.h>
#include <waker/program/parameter_printer.h>
#include <waker/program/parameter_reader.h>
#include <waker/program/prm_scanner.h>
#include <waker/program/program.h>
#include <waker/reliability/campaign_folder.h>
#include <waker/reliability/snapshots.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <new>
#include <sstream>

namespace Waker
{
  namespace
  {
    enum ExitCode
    {
      success           = 0,
      internal_error    = 1,
      wrong_input       = 2,
      numerical_failure = 3,
      signal_offset     = 128
    };


    /// The signal that asked the run to end, or 0. A handler can reach no
    /// other memory; the run sees it through RunOptions only.
    volatile std::sig_atomic_t received_signal = 0;


    extern "C" void
    note_signal(int signal)
    {
      received_signal = signal;
      std::signal(signal, SIG_DFL); // the second one ends at once
    }


    /// Three lines: where, what, what is allowed; tidy() makes one of each.
    void
    report(const UserError &error)
    {
      // In one piece: several ranks may have something to say.
      std::cerr << tidy(error.where) + "\n" + tidy(error.problem) +
                     "\nallowed: " + tidy(error.allowed) + "\n"
                << std::flush;
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
            return signal_offset +
                   (received_signal != 0 ? received_signal : SIGINT);
        }
      return internal_error;
    }


    /// One realisation, or a strength reduction.
    template <int dim>
    int
    run_one(const CommandLine &line, const Input &input)
    {
      if (n_ranks() > 1)
        throw UserError("command line",
                        "started on " + std::to_string(n_ranks()) + " ranks",
                        "one rank per realisation for now; waker campaign "
                        "takes any number");
      RunOptions options;
      options.validate_only = line.validate_only;
      options.resume        = line.resume;
      options.overwrite     = line.overwrite;
      options.interrupt     = &received_signal;
      if (line.command == Command::strength_reduction)
        return exit_code(run_strength_reduction<dim>(input.simulation,
                                                     options,
                                                     MPI_COMM_WORLD));

      const bool is_random = !input.reliability.fields.fields.empty();
      if (is_random != line.realisation.has_value())
        throw is_random
          ? UserError("Random fields/Names",
                      "there are random fields, but no --realisation i",
                      "waker run FILE --realisation i, waker campaign FILE, or "
                      "--set \"Random fields/Names=\"")
          : UserError("command line",
                      "--realisation is given, but nothing is random",
                      "a file with names in Random fields/Names");
      if (!is_random)
        return exit_code(run<dim>(input.simulation, options, MPI_COMM_WORLD));
      return exit_code(
        run<dim>(realisation_parameters(input, *line.realisation),
                 options,
                 MPI_COMM_WORLD,
                 realisation_setup<dim>(input, *line.realisation)));
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
      options.validate_only = line.validate_only;
      options.resume        = line.resume;
      options.overwrite     = line.overwrite;
      options.is_part       = line.is_part;
      options.chunk         = line.chunk;
      options.n_chunks      = line.n_chunks;
      options.first         = line.first;
      options.last          = line.last;
      options.interrupt     = &received_signal;
      return exit_code(run_campaign<dim>(scenarios, options, MPI_COMM_WORLD) ==
                           CampaignStatus::completed
                         ? RunStatus::completed
                         : RunStatus::interrupted);
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


    int
    start_and_compute(const CommandLine &line, char **argv)
    {
      ParameterLocations locations;
      const Scenarios    scenarios =
        read_scenarios(line.file, line.overrides, &locations);

      // MPI and PETSc would read options that are ours: only the name.
      int    n_arguments = 1;
      char  *name[]      = {argv[0], nullptr};
      char **arguments   = name;
      prepare_single_rank();
      const Utilities::MPI::MPI_InitFinalize mpi(n_arguments, arguments, 1);
      std::signal(SIGINT, note_signal);
      std::signal(SIGTERM, note_signal);
      try
        {
          return compute(line, scenarios);
        }
      catch (const UserError &error)
        {
          const UserError located = locations.located(error);
          if (n_ranks() == 1)
            throw located;
          // The other ranks may wait for this one: end them all.
          report(located);
          MPI_Abort(MPI_COMM_WORLD, wrong_input);
          throw;
        }
    }


    /// Look at a campaign's folder: needs neither MPI nor a simulation.
    int
    read_campaign(const CommandLine &line)
    {
      const std::string parameters = join_path(line.file, "parameters.prm");
      const std::string campaign   = join_path(line.file, "campaign.json");
      if (!std::ifstream(campaign))
        throw UserError(line.file,
                        "holds no campaign: no campaign.json can be read",
                        "the output folder of waker campaign");
      const Scenarios scenarios = read_scenarios(parameters, line.overrides);
      Log             log(std::cout, false);
      if (line.command == Command::merge)
        merge_campaign(line.file, *scenarios[0], line.all, log);
      else
        print_status(line.file, *scenarios[0], log);
      return success;
    }


    int
    execute(const CommandLine &line, char **argv)
    {
      switch (line.command)
        {
          case Command::none:
            std::cout << line.text;
            return success;
          case Command::parameters:
            print_parameters(std::cout, line.format);
            return success;
          case Command::run:
          case Command::strength_reduction:
          case Command::campaign:
            return start_and_compute(line, argv);
          case Command::status:
          case Command::merge:
            return read_campaign(line);
        }
      return internal_error;
    }


    int
    report_internal_error(const std::string &what)
    {
      std::cerr << "waker: internal error, please report it: " << tidy(what)
                << std::endl;
      return internal_error;
    }
  } // namespace


  int
  run_program(const int argc, char **argv)
  {
    deal_II_exceptions::suppress_stacktrace_in_exceptions();
    try
      {
        return execute(parse_command_line(argc, argv), argv);
      }
    catch (const UserError &error)
      {
        report(error);
        return wrong_input;
      }
    catch (const NumericalFailure &error)
      {
        std::cerr << "numerical failure: " << tidy(error.what()) << std::endl;
        return numerical_failure;
      }
    catch (const std::bad_alloc &)
      {
        std::cerr << "waker: out of memory" << std::endl;
        return internal_error;
      }
    catch (const ExceptionBase &error)
      {
        std::ostringstream text;
        text << error.get_exc_name() << " ";
        error.print_info(text);
        return report_internal_error(text.str());
      }
    catch (const std::exception &error)
      {
        return report_internal_error(error.what());
      }
    catch (...)
      {
        return report_internal_error("unknown exception");
      }
  }
} // namespace Waker
