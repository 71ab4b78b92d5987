// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_program_prm_scanner_h
#define waker_program_prm_scanner_h

#include <waker/base/text.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace Waker
{
  /// One value that the user gives, and where.
  struct PrmEntry
  {
    std::string section; // "Materials/clay", or empty at the top level
    std::string name;    // "Unit weight"
    std::string value;
    std::string where; // "dyke.prm:12" or "--set Materials/clay/Unit weight"

    /// "Section/Name".
    std::string
    path() const;
  };

  /// One `subsection` line.
  struct PrmSection
  {
    std::string path;  // "Materials/clay"
    std::string where; // "dyke.prm:9"
  };

  struct PrmContents
  {
    std::vector<PrmEntry>   entries;
    std::vector<PrmSection> sections;
  };

  /**
   * Take a .prm text apart, remembering line numbers, which deal.II's
   * ParameterHandler forgets. Its language: `subsection NAME`, `set NAME =
   * VALUE`, `end`, comments from `#` to the end of the line, and a backslash at
   * the end of a line that goes on in the next one.
   *
   * @param source name of the file, for messages
   * @throws UserError: a line that is none of the above or not in UTF-8, an
   * unbalanced `end`, an entry or section that appears twice
   */
  PrmContents
  scan_prm(std::istream &input, const std::string &source);

  /**
   * Take "Section/Name=value" of the command line apart.
   *
   * @throws UserError without `=` or without a name, given twice, or with a
   * value that a .prm file cannot hold
   */
  std::vector<PrmEntry>
  scan_overrides(const std::vector<std::string> &overrides);

  /// Does a value mean the same when it is read from a .prm file? Not with a
  /// "#", which begins a comment, several blanks in a row, a backslash at the
  /// end, control characters, or in another encoding than UTF-8.
  bool
  fits_prm(const std::string &value);

  /// "Section/Name", or only "Name" at the top level.
  std::string
  parameter_path(const std::string &section, const std::string &name);
} // namespace Waker

#endif
