// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/version.h>
#include <waker/program/command_line.h>

#include <CLI/CLI.hpp>
#include <algorithm>
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
    app.footer("Exit codes: 0 done, 2 wrong input (nothing is written), 3 "
               "numerical failure (recorded),\n130 or 143 interrupted after a "
               "checkpoint.");

    CLI::App *const run =
      add_simulation_command(app, line, "run", "one realisation");
    CLI::App *const strength_reduction =
      add_simulation_command(app,
                             line,
                             "strength-reduction",
                             "factor of safety: divide the strengths until the "
                             "dyke fails");
    CLI::App *const parameters =
      app.add_subcommand("parameters", "print every parameter");
    parameters
      ->add_option("--format", line.format, "prm, json, xml or markdown")
      ->check(CLI::IsMember({"prm", "json", "xml", "markdown"}));

    try
      {
        app.parse(argc, argv);
      }
    catch (const CLI::ParseError &error)
      {
        std::ostringstream text, unused;
        if (app.exit(error, text, unused) != 0)
          throw UserError("command line",
                          one_line(error.what()),
                          "waker run FILE, waker strength-reduction FILE, "
                          "waker parameters; waker --help says more");
        line.text = text.str();
        return line;
      }

    if (run->parsed())
      line.command = Command::run;
    else if (strength_reduction->parsed())
      line.command = Command::strength_reduction;
    else if (parameters->parsed())
      line.command = Command::parameters;
    return line;
  }
} // namespace Waker
