// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/choice.h>
#include <waker/base/errors.h>
#include <waker/base/text.h>
#include <waker/base/version.h>
#include <waker/program/command_line.h>
#include <waker/program/suggestions.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <limits>
#include <sstream>

namespace Waker
{
  namespace
  {
    /// The options that `run` and `strength-reduction` share.
    CLI::App *
    add_simulation_command(CLI::App          &app,
                           CommandLine       &line,
                           const std::string &name,
                           const std::string &description)
    {
      CLI::App *const command = app.add_subcommand(name, description);
      command
        ->add_option("FILE",
                     line.file,
                     "parameter file; - reads standard input")
        ->required();
      command
        ->add_option("--set",
                     line.overrides,
                     "\"Section/Name=value\": override a value; may be "
                     "repeated")
        ->allow_extra_args(false)
        ->type_name("TEXT");
      command->add_flag("--validate",
                        line.validate_only,
                        "only check the input, compute and write nothing");
      CLI::Option *const resume = command->add_flag(
        "--resume",
        line.resume,
        "go on from the last checkpoint of the output folder");
      command
        ->add_flag("--overwrite",
                   line.overwrite,
                   "replace an earlier run in the output folder")
        ->excludes(resume);
      return command;
    }


    /// As many realisations as Campaign/Realisations may have.
    constexpr std::uint64_t largest_number = std::numeric_limits<int>::max();


    /// A whole number of digits only; none for anything else, or beyond the
    /// largest.
    std::optional<std::uint64_t>
    whole_number(const std::string &text)
    {
      std::uint64_t     number = 0;
      const char *const end    = text.data() + text.size();
      const auto        result = std::from_chars(text.data(), end, number);
      if (result.ec != std::errc() || result.ptr != end ||
          number > largest_number)
        return {};
      return number;
    }


    std::uint64_t
    read_number(const std::string &option, const std::string &text)
    {
      const auto number = whole_number(text);
      if (!number)
        throw UserError("command line",
                        "--" + option + " is " + in_quotes(text),
                        "a whole number from 0 to " +
                          std::to_string(largest_number));
      return *number;
    }


    /// "a:b" or "i/n" of two whole numbers.
    std::pair<std::uint64_t, std::uint64_t>
    two_numbers(const std::string &option,
                const std::string &text,
                const char         separator,
                const std::string &allowed)
    {
      const std::size_t at = text.find(separator);
      if (at != std::string::npos)
        {
          const auto a = whole_number(text.substr(0, at));
          const auto b = whole_number(text.substr(at + 1));
          if (a && b)
            return {*a, *b};
        }
      throw UserError("command line",
                      "--" + option + " is " + in_quotes(text),
                      allowed + "; whole numbers up to " +
                        std::to_string(largest_number));
    }


    void
    read_parts(const std::optional<std::string> &chunk,
               const std::optional<std::string> &realisations,
               CommandLine                      &line)
    {
      line.is_part = chunk || realisations;
      if (line.is_part && line.overwrite)
        throw UserError("command line",
                        "--overwrite is given with --chunk or --realisations",
                        "one of them: parts join what is in the folder");
      const std::string one_of = "i/n with 1 <= i <= n, for example 2/10";
      if (chunk)
        {
          std::tie(line.chunk, line.n_chunks) =
            two_numbers("chunk", *chunk, '/', one_of);
          if (line.chunk < 1 || line.chunk > line.n_chunks)
            throw UserError("command line",
                            "--chunk is " + in_quotes(*chunk),
                            one_of);
        }
      const std::string range = "a:b with a < b: realisations a to b - 1";
      if (realisations)
        {
          std::tie(line.first, line.last) =
            two_numbers("realisations", *realisations, ':', range);
          if (line.first >= line.last)
            throw UserError("command line",
                            "--realisations is " + in_quotes(*realisations),
                            range);
        }
    }


    /// The first word that is neither a command nor an option: what is wrong
    /// with it, and what may be meant. Both are empty if there is none.
    std::pair<std::string, std::string>
    unknown_word(const CLI::App &app, const int argc, const char *const *argv)
    {
      const CLI::App *command = nullptr;
      for (int i = 1; i < argc; ++i)
        {
          const std::string        word      = argv[i];
          const std::string        name      = word.substr(0, word.find('='));
          const bool               is_option = word.rfind("--", 0) == 0;
          std::vector<std::string> known;
          if (is_option)
            for (const CLI::App *const where : {&app, command})
              {
                if (where != nullptr)
                  for (const CLI::Option *const option : where->get_options())
                    for (const std::string &long_name : option->get_lnames())
                      known.push_back("--" + long_name);
              }
          else if (command == nullptr)
            for (const CLI::App *const candidate : app.get_subcommands(nullptr))
              {
                if (candidate->get_name() == word)
                  command = candidate;
                known.push_back(candidate->get_name());
              }
          if (!known.empty() &&
              std::find(known.begin(), known.end(), name) == known.end())
            return {in_quotes(name) +
                      (is_option ? " is no option" : " is no command"),
                    did_you_mean(nearest_name(name, known))};
        }
      return {};
    }


    std::string
    one_line(std::string text)
    {
      std::replace(text.begin(), text.end(), '\n', ' ');
      return text;
    }
  } // namespace


  CommandLine
  parse_command_line(const int argc, const char *const *argv)
  {
    CommandLine line;
    CLI::App    app("Waker computes how a dyke fails, from the first slide to "
                    "flooding.",
                 "waker");
    app.set_version_flag("--version",
                         "waker " WAKER_VERSION " (" WAKER_BUILD_TYPE
                         ", native " WAKER_NATIVE ")");
    app.require_subcommand(1);
    app.footer(
      "Exit codes: 0 done, 2 wrong input (nothing is written), 3 "
      "numerical failure (recorded),\n4 a file could not be written (a "
      "full disk), 130 or 143 interrupted after a checkpoint or\n"
      "with what is finished in the journals.");

    CLI::App *const run =
      add_simulation_command(app, line, "run", "one realisation");
    CLI::App *const strength_reduction =
      add_simulation_command(app,
                             line,
                             "strength-reduction",
                             "factor of safety: divide the strengths until the "
                             "dyke fails");
    CLI::App *const campaign =
      add_simulation_command(app,
                             line,
                             "campaign",
                             "many realisations of random fields, their "
                             "probabilities and risk");
    std::optional<std::string> chunk, realisations, realisation, scenario;
    campaign->add_option("--chunk",
                         chunk,
                         "i/n: part i of n, for job arrays; joins what is in "
                         "the folder");
    campaign->add_option("--realisations",
                         realisations,
                         "a:b: only a to b - 1; joins what is in the folder");
    for (CLI::App *const command : {run, strength_reduction})
      {
        command->add_option("--realisation",
                            realisation,
                            "number of the realisation of the random fields");
        command->add_option("--scenario",
                            scenario,
                            "number of the scenario of the sweep, from 0");
      }

    CLI::App *const status =
      app.add_subcommand("status", "how far a campaign is, also while it runs");
    CLI::App *const merge =
      app.add_subcommand("merge",
                         "journals of a campaign to results.h5 and report/");
    for (CLI::App *const command : {status, merge})
      {
        command->add_option("FOLDER", line.file, "of the campaign")->required();
        command
          ->add_option("--set",
                       line.overrides,
                       "\"Section/Name=value\": override a value of Slides, "
                       "Histograms or Risk")
          ->allow_extra_args(false)
          ->type_name("TEXT");
      }
    merge->add_flag("--all",
                    line.all,
                    "take in realisations beyond the end that a stop rule set");

    CLI::App *const parameters =
      app.add_subcommand("parameters", "print every parameter");
    std::string format = name_of(line.format);
    parameters->add_option("--format", format, "prm, json, xml or markdown")
      ->check(CLI::IsMember(choice_names<ParameterFormat>()));

    try
      {
        app.parse(argc, argv);
      }
    catch (const CLI::ParseError &error)
      {
        std::ostringstream text, unused;
        if (app.exit(error, text, unused) != 0)
          {
            const auto [problem, meant] = unknown_word(app, argc, argv);
            throw UserError("command line",
                            problem.empty() ? one_line(error.what()) : problem,
                            meant +
                              "waker run FILE, waker strength-reduction FILE, "
                              "waker campaign FILE, waker status FOLDER, waker "
                              "merge FOLDER, waker parameters; waker --help "
                              "says more");
          }
        line.text = text.str();
        return line;
      }

    if (run->parsed())
      line.command = Command::run;
    else if (strength_reduction->parsed())
      line.command = Command::strength_reduction;
    else if (campaign->parsed())
      line.command = Command::campaign;
    else if (status->parsed())
      line.command = Command::status;
    else if (merge->parsed())
      line.command = Command::merge;
    else if (parameters->parsed())
      line.command = Command::parameters;
    line.format = choice_named<ParameterFormat>(format, "--format");
    read_parts(chunk, realisations, line);
    if (realisation)
      line.realisation = read_number("realisation", *realisation);
    if (scenario)
      line.scenario = read_number("scenario", *scenario);
    return line;
  }
} // namespace Waker
