// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_phreatic_line_h
#define waker_loads_phreatic_line_h

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace Waker
{
  /// The line at which the pressure of the water in the ground is 0, in space
  /// the same along z. Beyond its ends it is level. Lines of heads, and those
  /// between which heads are given, are alike (loads/heads.h).
  class PhreaticLine
  {
  public:
    /// None.
    PhreaticLine() = default;

    /// @param text "x, y; x, y; ...": two corners (m) or more, x ascending;
    /// empty: no line
    /// @param path of the parameter, for the error
    /// @throws UserError path
    PhreaticLine(const std::string &text, const std::string &path);

    /// @param places of its corners (m), in any order
    /// @param height at x
    PhreaticLine(std::vector<double>                        places,
                 const std::function<double(const double)> &height);

    bool
    empty() const
    {
      return corners.empty();
    }

    const std::vector<std::array<double, 2>> &
    all() const
    {
      return corners;
    }

    /// Its height (m) at x; there must be a line.
    double
    height(const double x) const;

    /// The line whose height is (1 - share) times that of a and share times
    /// that of b, everywhere.
    static PhreaticLine
    between(const PhreaticLine &a, const PhreaticLine &b, const double share);

    /// Where it begins and ends (m).
    double
    begin() const
    {
      return corners.front()[0];
    }

    double
    end() const
    {
      return corners.back()[0];
    }

  private:
    std::vector<std::array<double, 2>> corners;
  };


  /// Lines by the level of the water outside: between two levels there is a
  /// line between theirs; below the first level the first, above the last the
  /// last.
  class PhreaticLines
  {
  public:
    /// One, at any level, or none.
    explicit PhreaticLines(const PhreaticLine &line);

    /// @param text "level: x, y; x, y; ... | level: ...", two or more, levels
    /// (m) ascending
    /// @param path of the parameter, for the error
    /// @throws UserError path
    PhreaticLines(const std::string &text, const std::string &path);

    /// The line when the water stands at this level (m).
    PhreaticLine
    at(const double level) const;

    const std::vector<PhreaticLine> &
    all() const
    {
      return lines;
    }

  private:
    std::vector<double>       levels; // of the lines; of one alone none
    std::vector<PhreaticLine> lines;
  };
} // namespace Waker

#endif
