// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_loads_heads_h
#define waker_loads_heads_h

#include <waker/loads/following_line.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace Waker
{
  using namespace dealii;

  /// Heads (m) along a line in the ground, as of an aquifer: subsection
  /// "Head lines/<name>".
  struct HeadLineParameters
  {
    std::string name;           // of the subsection
    std::string line;           // "x, y; x, y; ..." (m), x ascending
    std::string lines_by_level; // instead: see PoreWaterParameters
    std::string daily_line;     // empty: the same
    std::string delay = "0";    // see LineDelay

    void
    add_parameters(ParameterHandler &prm);

    /// @throws UserError "Head lines/<name>/..."
    void
    check() const;

    bool
    follows_water() const;

    /// @throws UserError "Head lines/<name>/..."
    PhreaticLines
    lines() const;

    FollowingLine
    following() const;

    /// The same with the daily line as the line.
    HeadLineParameters
    of_the_daily_water() const;
  };


  /// A line in the ground at which heads are given: subsection "Reference
  /// lines/<name>".
  struct ReferenceLineParameters
  {
    std::string name; // of the subsection
    std::string line; // "x, y; x, y; ..." (m), x ascending
    /// Names of the head lines that hold above it and below it; empty: the
    /// phreatic line.
    std::string top_head_line;
    std::string bottom_head_line;

    void
    add_parameters(ParameterHandler &prm);

    /// @throws UserError "Reference lines/<name>/Line"
    void
    check() const;

    PhreaticLine
    place() const;
  };


  /**
   * The heads of the water in the ground at one moment. Over the first
   * reference line the head is that of the phreatic line; between two it is
   * interpolated vertically from the upper one's bottom head line to the lower
   * one's top head line; below the last it is its bottom head line.
   */
  class Heads
  {
  public:
    struct Reference
    {
      PhreaticLine line, above, below; // place; heads over and under it
    };

    /// @param references from top to bottom
    Heads(const PhreaticLine           &phreatic,
          const std::vector<Reference> &references)
      : phreatic_line(phreatic)
      , references(references)
    {}

    /// The head (m) at a place; there must be a phreatic line.
    double
    at(const double x, const double y) const;

    const PhreaticLine &
    phreatic() const
    {
      return phreatic_line;
    }

  private:
    PhreaticLine           phreatic_line;
    std::vector<Reference> references;
  };


  /// The numbers of the lines from top to bottom.
  /// @throws UserError "Reference lines/<name>/Line": it crosses another
  std::vector<unsigned int>
  from_top_to_bottom(const std::vector<ReferenceLineParameters> &lines);
} // namespace Waker

#endif
