// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/base/errors.h>
#include <waker/base/file_error.h>
#include <waker/base/log.h>
#include <waker/base/read_file.h>
#include <waker/campaign/campaign_folder.h>
#include <waker/program/command_line.h>
#include <waker/program/compute.h>
#include <waker/program/exit_codes.h>
#include <waker/program/parameter_printer.h>
#include <waker/program/parameter_reader.h>
#include <waker/program/program.h>
#include <waker/store/campaign_files.h>

#include <chrono>
#include <cstdlib>
#include <initializer_list>
#include <iostream>
#include <thread>

namespace Waker
{
  namespace
  {
    /// What Open MPI, PMIx or PMI say to a process that they have started;
    /// 0 if it is alone.
    int
    from_launcher(const std::initializer_list<const char *> names)
    {
      for (const char *const name : names)
        if (const char *const value = std::getenv(name))
          return std::atoi(value);
      return 0;
    }


    /// Before MPI is started.
    int
    rank_of_launcher()
    {
      return from_launcher({"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"});
    }


    /// Of several ranks the first one alone gets what is typed, or piped.
    void
    check_input_for_ranks(const CommandLine &line)
    {
      if (line.file == "-" &&
          (rank_of_launcher() > 0 ||
           from_launcher({"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) > 1))
        throw UserError("command line",
                        "\"-\" on several ranks: standard input reaches the "
                        "first of them only",
                        "the name of a file that all of them can read");
    }


    /// Look at a campaign's folder: needs neither MPI nor a simulation.
    int
    read_campaign(const CommandLine &line)
    {
      const std::string parameters =
        campaign_path(line.file, CampaignFile::parameters);
      const std::string campaign = campaign_path(line.file, CampaignFile::info);
      try
        {
          read_file(campaign);
        }
      catch (const UserError &error)
        {
          throw UserError(line.file,
                          "holds no campaign: no campaign.json can be read: " +
                            error.problem,
                          "the output folder of waker campaign");
        }
      // Nothing is computed: the measurements, say, may be gone by now.
      const Scenarios scenarios = read_scenarios(parameters,
                                                 line.overrides,
                                                 nullptr,
                                                 FileContents::left_out);
      Log             log(std::cout, false);
      if (line.command == Command::merge)
        return merge_campaign(line.file, *scenarios[0], line.all, log)
                 ? success
                 : numerical_failure;
      print_status(line.file, *scenarios[0], log);
      return success;
    }


    int
    run_command(const CommandLine &line, char **argv)
    {
      const bool computes = line.command == Command::run ||
                            line.command == Command::strength_reduction ||
                            line.command == Command::campaign;
      // Once is enough.
      if (!computes && rank_of_launcher() > 0)
        return success;
      check_input_for_ranks(line);
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
            return compute(line, argv);
          case Command::status:
          case Command::merge:
            return read_campaign(line);
        }
      return internal_error;
    }


    /// Where MPI has not been started: several ranks have read the same, and
    /// meet the same mistake. The first one says so and ends, upon which who
    /// has started them ends the others before they say it again.
    void
    wait_for_first_rank()
    {
      if (rank_of_launcher() > 0)
        std::this_thread::sleep_for(std::chrono::seconds(5));
    }


    int
    execute(const CommandLine &line, char **argv)
    {
      const int code = run_command(line, argv);
      // What these print is all that they are for.
      const bool is_for_the_screen = line.command == Command::none ||
                                     line.command == Command::parameters ||
                                     line.command == Command::status;
      if (is_for_the_screen && !std::cout.flush())
        throw FileError("standard output", "cannot be written");
      return code;
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
    catch (...)
      {
        wait_for_first_rank();
        return report_exception();
      }
  }
} // namespace Waker
