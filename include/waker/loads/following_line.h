// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_following_line_h
#define waker_loads_following_line_h

#include <waker/loads/phreatic_line.h>

#include <array>
#include <string>
#include <vector>

namespace Waker
{
  /**
   * How long the water in the ground takes to follow the water outside. At each
   * place x the level L that has arrived follows the level h outside as
   *   dL/dt = (h - L) / T(x):
   * after a step of h, 63 % has arrived after T. T is given at places; between
   * two of them what has arrived is interpolated, beyond them it is constant.
   */
  class LineDelay
  {
  public:
    /// None.
    LineDelay() = default;

    /// @param text T (s); or "x: T, x: T, ..." (m, s), x ascending
    /// @param path of the parameter, for the error
    /// @throws UserError path
    LineDelay(const std::string &text, const std::string &path);

    /// The largest T (s).
    double
    largest() const;

    /// The levels that have arrived at the places when the water has always
    /// stood at `level` (m).
    std::vector<double>
    start(const double level) const
    {
      return std::vector<double>(places.size(), level);
    }

    /// In dt (s) the level outside goes straight from `before` to `after` (m).
    /// Exact, whatever dt.
    void
    follow(const double         before,
           const double         after,
           const double         dt,
           std::vector<double> &arrived) const;

    /// What has arrived at x (m).
    double
    level_at(const double x, const std::vector<double> &arrived) const;

    /// x (m) and T (s).
    const std::vector<std::array<double, 2>> &
    all() const
    {
      return places;
    }

  private:
    std::vector<std::array<double, 2>> places = {{{0., 0.}}};
  };


  /// A line by the level of the water outside that takes its time to follow.
  class FollowingLine
  {
  public:
    FollowingLine(const PhreaticLines &lines, const LineDelay &delay)
      : lines(lines)
      , line_delay(delay)
    {}

    /// The line for the levels that have arrived. It has corners where the
    /// lines or the delay have some, and is straight between them.
    PhreaticLine
    at(const std::vector<double> &arrived) const;

    const LineDelay &
    delay() const
    {
      return line_delay;
    }

    /// Does it follow at all?
    bool
    moves() const
    {
      return lines.all().size() > 1;
    }

  private:
    PhreaticLines lines;
    LineDelay     line_delay;
  };
} // namespace Waker

#endif
