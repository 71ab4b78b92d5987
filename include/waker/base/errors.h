// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_errors_h
#define waker_base_errors_h

#include <stdexcept>
#include <string>

namespace Waker
{
  /**
   * A mistake of the user's: bad input, an unwritable folder, a checkpoint of
   * another case. The program prints it in three lines (where, what, what is
   * allowed) and exits with code 2; nothing has been written by then.
   *
   * Rooms below `program/` know a parameter's path only ("Water/Level");
   * `program/` turns it into file and line.
   */
  class UserError : public std::runtime_error
  {
  public:
    /**
     * @param where   path of the parameter ("Section/Name"), or file[:line]
     * @param what    what is wrong, with the offending value
     * @param allowed what would be right
     */
    UserError(const std::string &where,
              const std::string &what,
              const std::string &allowed)
      : std::runtime_error(where + ": " + what + "; allowed: " + allowed)
      , where(where)
      , problem(what)
      , allowed(allowed)
    {}

    std::string where;
    std::string problem;
    std::string allowed;
  };

  /**
   * Numerical trouble that no retry has cured: a step that does not converge
   * at the smallest time step, a material point that left the background grid.
   * The run records it and ends with the outcome "numerical failure".
   */
  class NumericalFailure : public std::runtime_error
  {
  public:
    using std::runtime_error::runtime_error;
  };
} // namespace Waker

#endif
