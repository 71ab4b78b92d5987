// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_program_command_line_h
#define waker_program_command_line_h

#include <string>
#include <vector>

namespace Waker
{
  enum class Command
  {
    run,
    strength_reduction,
    parameters,
    none // help or version: the text says it all
  };

  /// What the user typed.
  struct CommandLine
  {
    Command                  command = Command::none;
    std::string              file; // "-": standard input
    std::vector<std::string> overrides;
    bool                     validate_only = false;
    bool                     resume        = false;
    bool                     overwrite     = false;
    std::string              format        = "prm"; // of `parameters`
    std::string              text;                  // to print for `none`
  };

  /// @throws UserError for anything that cannot be understood
  CommandLine
  parse_command_line(const int argc, const char *const *argv);
} // namespace Waker

#endif
