// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_time_function_h
#define waker_base_time_function_h

#include <waker/base/expression.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Waker
{
  /**
   * A value in time that the user writes: a number, an expression of t (s), or
   * a table "t0: y0, t1: y1, ..." with straight lines between its entries and
   * constant before the first and after the last.
   *
   * Copies share their parser: not for several threads at a time.
   */
  class TimeFunction
  {
  public:
    /// Constant.
    explicit TimeFunction(const double value = 0.);

    /// @param path of the parameter, for the error
    /// @throws UserError if the text is none of the three, depends on the
    /// place, or if the table's times do not ascend
    TimeFunction(const std::string &text, const std::string &path);

    double
    value(const double t) const;

    /// Does it depend on the time?
    bool
    moves() const;

    /// The least value of a table; of an expression that at t = 0.
    double
    least() const;

    /// The last time at which its value changes (s): of a table the end of the
    /// last line that is not level; LastChange::never of a constant,
    /// LastChange::unknown of an expression.
    double
    last_change() const;

    /// The first corner of a table after a time (s); infinity if none comes, or
    /// if it is no table.
    double
    next_corner(const double t) const;

    /// The first time at which a table has its largest value (s); of an
    /// expression 0.
    double
    time_of_largest() const;

    /// Does it change between two times? A table: exactly; an expression: see
    /// Waker::varies().
    bool
    varies(const double from, const double to) const;

  private:
    std::vector<std::pair<double, double>> table;      // time, value; ascending
    std::shared_ptr<const Expression<2>>   expression; // or null
  };
} // namespace Waker

#endif
