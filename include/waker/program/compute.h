// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_program_compute_h
#define waker_program_compute_h

#include <waker/program/command_line.h>

namespace Waker
{
  /**
   * The commands that simulate: run, strength-reduction, campaign. Starts MPI,
   * and ends the run cleanly at SIGINT and SIGTERM. If one of several ranks
   * fails it says why and ends all of them.
   *
   * @param argv of main(): MPI wants the program's name
   * @return the exit code
   * @throws UserError with file and line, and others, on one rank
   */
  int
  compute(const CommandLine &line, char **argv);
} // namespace Waker

#endif
