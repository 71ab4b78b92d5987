// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_program_suggestions_h
#define waker_program_suggestions_h

#include <waker/program/declared_parameters.h>
#include <waker/program/prm_scanner.h>

#include <string>
#include <vector>

namespace Waker
{
  /// The candidate that `name` most likely stands for (fewest edits, capitals
  /// ignored), or nothing where none is near.
  std::string
  nearest_name(const std::string              &name,
               const std::vector<std::string> &candidates);

  /// "did you mean "Water"? ", or nothing.
  std::string
  did_you_mean(const std::string &name);

  /// @throws UserError if the section does not exist, with the nearest one
  void
  check_section(const PrmSection &section, const DeclaredIndex &declared);

  /**
   * @return the declaration of an entry
   * @throws UserError if there is none, with the nearest name, or the section
   * where that name is at home, or the path that is meant
   */
  const DeclaredParameter &
  find_declared(const PrmEntry &entry, const DeclaredIndex &declared);
} // namespace Waker

#endif
