// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_base_expression_h
#define waker_base_expression_h

#include <deal.II/base/point.h>

#include <waker/base/last_change.h>
#include <waker/base/named_expression.h>

#include <string>

namespace Waker
{
  using namespace dealii;

  /**
   * A function of place and time that the user writes: x, y, z (m), t (s), pi
   * and the functions of muParser. Not for several threads at a time.
   */
  template <int dim>
  class Expression
  {
  public:
    /// @param path of the parameter, for the error
    /// @param or_else what else the parameter takes, for the error
    /// @throws UserError if the text is no expression
    Expression(const std::string &text,
               const std::string &path,
               const std::string &or_else = "");

    double
    value(const Point<dim> &x, const double t) const;

    const std::string &
    text() const
    {
      return expression.text();
    }

    /// Does it contain the time?
    bool
    moves() const
    {
      return expression.uses(dim);
    }

    /// The last time at which it changes (s): LastChange::never or unknown.
    double
    last_change() const
    {
      return moves() ? LastChange::unknown : LastChange::never;
    }

    /// Does it change at x between two times? See Waker::varies().
    bool
    varies(const Point<dim> &x, const double from, const double to) const;

    /// Is it the same everywhere?
    bool
    is_uniform() const;

  private:
    NamedExpression expression; // of x, y, (z,) t
  };
} // namespace Waker

#endif
