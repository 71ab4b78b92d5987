// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/parameter_handler.h>

#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/loads/heads.h>

#include <algorithm>
#include <numeric>

namespace Waker
{
  void
  HeadLineParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Line",
      line,
      "Corners \"x, y; x, y; ...\" (m), x ascending, of the "
      "line of heads: the height to which water would rise in "
      "a standpipe at x. It must reach over all soil. Reference "
      "lines say where it holds.",
      Patterns::Anything());
    prm.add_parameter("Daily line",
                      daily_line,
                      "The same of the days on which the soil consolidated "
                      "(Pore water/Daily phreatic line). Empty: the same line.",
                      Patterns::Anything());
    prm.add_parameter("Lines by level",
                      lines_by_level,
                      "Instead of Line: lines that follow the water outside, "
                      "as Pore water/Lines by level.",
                      Patterns::Anything());
    prm.add_parameter("Delay",
                      delay,
                      "How long the head takes to follow the water outside, as "
                      "Pore water/Delay (s).",
                      Patterns::Anything());
  }


  void
  HeadLineParameters::check() const
  {
    const std::string path = "Head lines/" + name + "/";
    if (follows_water() && !tidy(line).empty())
      throw UserError(path + "Lines by level",
                      "is there, and so is Line",
                      "one of them");
    if (!follows_water() && tidy(line).empty())
      throw UserError(path + "Line", "is empty", "a line, or Lines by level");
    lines();
    LineDelay(delay, path + "Delay");
    PhreaticLine(daily_line, path + "Daily line");
  }


  bool
  HeadLineParameters::follows_water() const
  {
    return !tidy(lines_by_level).empty();
  }


  PhreaticLines
  HeadLineParameters::lines() const
  {
    const std::string path = "Head lines/" + name + "/";
    if (follows_water())
      return PhreaticLines(lines_by_level, path + "Lines by level");
    return PhreaticLines(PhreaticLine(line, path + "Line"));
  }


  FollowingLine
  HeadLineParameters::following() const
  {
    return FollowingLine(lines(),
                         LineDelay(delay, "Head lines/" + name + "/Delay"));
  }


  HeadLineParameters
  HeadLineParameters::of_the_daily_water() const
  {
    HeadLineParameters daily = *this;
    if (!tidy(daily_line).empty())
      {
        daily.line           = daily_line;
        daily.lines_by_level = "";
      }
    return daily;
  }


  void
  ReferenceLineParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Line",
                      line,
                      "Corners \"x, y; x, y; ...\" (m), x ascending, of a line "
                      "in the ground at which heads are given, such as the top "
                      "or the bottom of a layer. It must reach over all soil, "
                      "and cross no other one.",
                      Patterns::Anything());
    prm.add_parameter("Top head line",
                      top_head_line,
                      "Name of the head line that holds just above it: from "
                      "there to the reference line over it the head is "
                      "interpolated. Above the first reference line it is the "
                      "phreatic line, and this is not used. Empty: the "
                      "phreatic line.",
                      Patterns::Anything());
    prm.add_parameter("Bottom head line",
                      bottom_head_line,
                      "Name of the head line that holds just below it, and "
                      "below the last reference line all the way down. Empty: "
                      "the phreatic line.",
                      Patterns::Anything());
  }


  void
  ReferenceLineParameters::check() const
  {
    if (place().empty())
      throw UserError("Reference lines/" + name + "/Line",
                      "is empty",
                      "the corners of a line (m)");
  }


  PhreaticLine
  ReferenceLineParameters::place() const
  {
    return PhreaticLine(line, "Reference lines/" + name + "/Line");
  }


  double
  Heads::at(const double x, const double y) const
  {
    if (references.empty())
      return phreatic_line.height(x);
    for (std::size_t k = 0; k < references.size(); ++k)
      {
        const double low = references[k].line.height(x);
        if (y < low)
          continue;
        if (k == 0)
          return phreatic_line.height(x);
        const Reference &over  = references[k - 1];
        const double     high  = over.line.height(x); // above y
        const double     share = (high - y) / (high - low);
        return (1. - share) * over.below.height(x) +
               share * references[k].above.height(x);
      }
    return references.back().below.height(x);
  }


  std::vector<unsigned int>
  from_top_to_bottom(const std::vector<ReferenceLineParameters> &lines)
  {
    std::vector<PhreaticLine> places;
    std::vector<double>       corners; // x of all
    for (const ReferenceLineParameters &line : lines)
      {
        places.push_back(line.place());
        for (const auto &corner : places.back().all())
          corners.push_back(corner[0]);
      }
    const auto sum = [&](const unsigned int i) {
      double heights = 0.;
      for (const double x : corners)
        heights += places[i].height(x);
      return heights;
    };
    std::vector<unsigned int> order(lines.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
      return sum(a) > sum(b);
    });
    // They may touch: where a layer ends.
    for (std::size_t k = 1; k < order.size(); ++k)
      for (const double x : corners)
        {
          const unsigned int high = order[k - 1], low = order[k];
          const double       over  = places[high].height(x);
          const double       under = places[low].height(x);
          if (under > over)
            throw UserError("Reference lines/" + lines[low].name + "/Line",
                            "crosses " + lines[high].name +
                              ": at x = " + in_digits(x) + " m it lies at " +
                              in_digits(under) + " m, that one at " +
                              in_digits(over) + " m, and elsewhere below it",
                            "lines that do not cross; they may touch");
        }
    return order;
  }
} // namespace Waker
