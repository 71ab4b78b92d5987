// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <waker/base/errors.h>
#include <waker/program/command_line.h>
#include <waker/program/parameter_printer.h>
#include <waker/program/parameter_reader.h>
#include <waker/program/prm_scanner.h>
#include <waker/program/program.h>
#include <waker/simulation/parameters.h>
#include <waker/simulation/run.h>

#include <csignal>
#include <cstdlib>
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


    template <int dim>
    RunStatus
    dispatch(const Command     command,
             const Parameters &parameters,
             const RunOptions &options)
    {
      return command == Command::run
               ? run<dim>(parameters, options, MPI_COMM_WORLD)
               : run_strength_reduction<dim>(parameters,
                                             options,
                                             MPI_COMM_WORLD);
    }


    int
    compute(const CommandLine &line, const Parameters &parameters, char **argv)
    {
      // MPI and PETSc would read options that are ours: only the name.
      int    n_arguments = 1;
      char  *name[]      = {argv[0], nullptr};
      char **arguments   = name;
      prepare_single_rank();
      const Utilities::MPI::MPI_InitFinalize mpi(n_arguments, arguments, 1);
      if (Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) > 1)
        {
          if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) > 0)
            return wrong_input;
          throw UserError("command line",
                          "started on " +
                            std::to_string(
                              Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD)) +
                            " ranks",
                          "one rank per realisation for now");
        }

      std::signal(SIGINT, note_signal);
      std::signal(SIGTERM, note_signal);
      RunOptions options;
      options.validate_only = line.validate_only;
      options.resume        = line.resume;
      options.overwrite     = line.overwrite;
      options.interrupt     = &received_signal;

      const RunStatus status =
        parameters.dimension == 2
          ? dispatch<2>(line.command, parameters, options)
          : dispatch<3>(line.command, parameters, options);
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
            {
              ParameterLocations locations;
              const auto         parameters =
                read_parameters(line.file, line.overrides, &locations);
              try
                {
                  return compute(line, *parameters, argv);
                }
              catch (const UserError &error)
                {
                  throw locations.located(error);
                }
            }
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
        // tidy() makes one line of each.
        std::cerr << tidy(error.where) << '\n'
                  << tidy(error.problem) << '\n'
                  << "allowed: " << tidy(error.allowed) << std::endl;
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
