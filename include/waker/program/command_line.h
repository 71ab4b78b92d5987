// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_program_command_line_h
#define waker_program_command_line_h

#include <waker/program/parameter_printer.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace Waker
{
  enum class Command
  {
    run,
    strength_reduction,
    campaign,
    status,
    merge,
    parameters,
    none // help or version: the text says it all
  };

  /// What the user typed.
  struct CommandLine
  {
    Command                  command = Command::none;
    std::string              file; // "-": standard input; or a folder
    std::vector<std::string> overrides;
    bool                     validate_only = false;
    bool                     resume        = false;
    bool                     overwrite     = false;
    // Of `run`: which realisation of the random fields, which scenario.
    std::optional<std::uint64_t> realisation;
    std::uint64_t                scenario = 0;
    // Of `campaign`: part `chunk` of n_chunks, realisations first <= i < last.
    bool          is_part  = false;
    std::uint64_t chunk    = 1;
    std::uint64_t n_chunks = 1;
    std::uint64_t first    = 0;
    std::uint64_t last     = -1;
    bool          all      = false; // of `merge`: surplus realisations, too

    ParameterFormat format = ParameterFormat::prm; // of `parameters`
    std::string     text;                          // to print for `none`
  };

  /// @throws UserError for anything that cannot be understood
  CommandLine
  parse_command_line(const int argc, const char *const *argv);
} // namespace Waker

#endif
