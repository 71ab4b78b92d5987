// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_program_parameter_reader_h
#define waker_program_parameter_reader_h

#include <waker/base/errors.h>
#include <waker/program/parameter_hash.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace Waker
{
  struct Input;
  struct Parameters;

  /// Where each parameter of a case was set: turns the paths in the errors of
  /// all rooms into files and lines.
  class ParameterLocations
  {
  public:
    /// Name of the file, or "standard input".
    std::string source;
    /// "dyke.prm:12" or "--set Section/Name" by path of parameter or section.
    std::map<std::string, std::string> lines;
    /// Paths of all parameters that exist.
    std::set<std::string> known;

    /**
     * "dyke.prm:12" where the file sets the parameter (or opens the section),
     * "dyke.prm (default of Section/Name)" where it does not. Anything that is
     * no path of a parameter is returned as it is.
     */
    std::string
    where(const std::string &path) const;

    /// The same error with `where` turned into file and line.
    UserError
    located(const UserError &error) const;
  };

  /**
   * Read and check a file, and the scenarios that its sweep makes of it.
   *
   * @param source a .prm file, or "-" for standard input
   * @param overrides "Section/Name=value", stronger than the file
   * @param locations if not null, gets the line numbers, for errors that are
   *        found later
   * @param contents of the files that the input names: left out, they need not
   *        be there, but then the hashes are those of nothing that can be run
   * @return one input per value of the sweep; one without a sweep
   * @throws UserError with file and line, or with "--set Section/Name"
   */
  std::vector<std::unique_ptr<Input>>
  read_scenarios(const std::string              &source,
                 const std::vector<std::string> &overrides,
                 ParameterLocations             *locations = nullptr,
                 const FileContents contents = FileContents::count);

  /// What a file says about one simulation, without its sweep.
  std::unique_ptr<Parameters>
  read_parameters(const std::string              &source,
                  const std::vector<std::string> &overrides,
                  ParameterLocations             *locations = nullptr);
} // namespace Waker

#endif
