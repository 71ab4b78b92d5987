// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_program_exit_codes_h
#define waker_program_exit_codes_h

namespace Waker
{
  enum ExitCode
  {
    success           = 0,
    internal_error    = 1,
    wrong_input       = 2,
    numerical_failure = 3,
    file_error        = 4,
    signal_offset     = 128
  };

  /// Inside a catch block: say on standard error what has gone wrong, a user's
  /// mistake and a file that cannot be written in three lines. @return the exit
  /// code for it
  int
  report_exception();
} // namespace Waker

#endif
