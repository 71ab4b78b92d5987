// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_program_parameter_names_h
#define waker_program_parameter_names_h

#include <waker/program/declared_parameters.h>
#include <waker/program/prm_scanner.h>

#include <vector>

namespace Waker
{
  /**
   * The overrides replace entries of the file. A list of names that becomes
   * shorter takes the subsections of the names that it leaves out with it:
   * --set "Random fields/Names=" switches the fields off.
   */
  void
  override_entries(PrmContents                 &contents,
                   const std::vector<PrmEntry> &overrides);

  /**
   * The lists of names, each of which must have a subsection: a forgotten one
   * would silently mean default values.
   *
   * @throws UserError also for a name that one of the files, which it must all
   * survive, cannot hold
   */
  ParameterNames
  read_names(const PrmContents &contents);
} // namespace Waker

#endif
