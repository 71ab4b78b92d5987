// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_program_program_h
#define waker_program_program_h

namespace Waker
{
  /**
   * The program `waker`: reads the command line and does what it says.
   *
   * Wrong input gives three lines on standard error: where, what is wrong,
   * what is allowed. Catches everything. MPI is started only when something
   * is computed: it takes longer than all the rest of reading a case.
   *
   * @return the exit code: 0 done, 1 internal error, 2 wrong input, 3
   * numerical failure, 4 a file could not be written, 128 + signal when
   * interrupted
   */
  int
  run_program(const int argc, char **argv);
} // namespace Waker

#endif
