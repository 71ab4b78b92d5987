// SPDX-License-Identifier: LGPL-2.1-or-later
#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/loads/phreatic_line.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  namespace
  {
    /// No water in the ground stands further above or below datum (m).
    constexpr double farthest = 1e5;
    /// Levels that are nearer to each other (m) are one, and a slip.
    constexpr double nearest_levels = 1e-3;
  } // namespace


  PhreaticLine::PhreaticLine(const std::string &text, const std::string &path)
  {
    if (tidy(text).empty())
      return;
    const std::string allowed =
      "two corners or more, \"x, y; x, y\" (m), x ascending";
    std::vector<std::string> items = split(text, ';');
    if (tidy(items.back()).empty())
      items.pop_back(); // a semicolon at the end
    for (const std::string &item : items)
      {
        const std::vector<std::string> numbers = split(item, ',');
        std::array<double, 2>          corner;
        if (numbers.size() != 2 || !read_number(numbers[0], corner[0]) ||
            !read_number(numbers[1], corner[1]))
          throw UserError(path,
                          "corner " + std::to_string(corners.size() + 1) +
                            " is \"" + tidy(item) + "\", not two numbers",
                          allowed);
        if (!(std::abs(corner[1]) <= farthest))
          throw UserError(path,
                          "corner " + std::to_string(corners.size() + 1) +
                            " has y = " + in_digits(corner[1]) + " m",
                          "heights within " + in_digits(farthest) + " m of 0");
        if (!corners.empty() && !(corner[0] > corners.back()[0]))
          throw UserError(path,
                          "corner " + std::to_string(corners.size() + 1) +
                            " has x = " + in_digits(corner[0]) +
                            " m after x = " + in_digits(corners.back()[0]) +
                            " m",
                          allowed);
        corners.push_back(corner);
      }
    if (corners.size() < 2)
      throw UserError(path,
                      "\"" + tidy(text) + "\" has " +
                        std::to_string(corners.size()) + " corner",
                      allowed);
  }


  PhreaticLine::PhreaticLine(std::vector<double>                        places,
                             const std::function<double(const double)> &height)
  {
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    for (const double x : places)
      corners.push_back({{x, height(x)}});
  }


  double
  PhreaticLine::height(const double x) const
  {
    if (x <= begin())
      return corners.front()[1];
    if (x >= end())
      return corners.back()[1];
    const auto next =
      std::upper_bound(corners.begin(),
                       corners.end(),
                       x,
                       [](const double value, const auto &corner) {
                         return value < corner[0];
                       });
    const auto  &b = *next, &a = *(next - 1);
    const double share = (x - a[0]) / (b[0] - a[0]);
    return a[1] + share * (b[1] - a[1]);
  }


  PhreaticLine
  PhreaticLine::between(const PhreaticLine &a,
                        const PhreaticLine &b,
                        const double        share)
  {
    std::vector<double> places;
    for (const PhreaticLine *const line : {&a, &b})
      for (const auto &corner : line->corners)
        places.push_back(corner[0]);
    return PhreaticLine(places, [&](const double x) {
      return (1. - share) * a.height(x) + share * b.height(x);
    });
  }


  PhreaticLines::PhreaticLines(const PhreaticLine &line)
    : lines(line.empty() ? 0 : 1, line)
  {}


  PhreaticLines::PhreaticLines(const std::string &text, const std::string &path)
  {
    const std::string allowed =
      "two lines or more, \"level: x, y; x, y | level: ...\" (m), levels "
      "ascending";
    for (const std::string &item : split(text, '|'))
      {
        const std::size_t colon = item.find(':');
        double            level = 0.;
        if (colon == std::string::npos ||
            !read_number(item.substr(0, colon), level) || !std::isfinite(level))
          throw UserError(path,
                          in_quotes(item) + " does not begin with a level",
                          allowed);
        if (!levels.empty() && !(level > levels.back()))
          throw UserError(path,
                          "has the level " + in_digits(level) + " m after " +
                            in_digits(levels.back()) + " m",
                          allowed);
        if (!levels.empty() && level - levels.back() < nearest_levels)
          throw UserError(path,
                          "has the levels " + in_digits(levels.back()) +
                            " and " + in_digits(level) +
                            " m, which are nearly one: the line would jump "
                            "from one to the other",
                          "levels that are at least " +
                            in_digits(nearest_levels) + " m apart");
        const PhreaticLine line(item.substr(colon + 1), path);
        if (line.empty())
          throw UserError(path,
                          "has no corners at the level " + in_digits(level) +
                            " m",
                          allowed);
        levels.push_back(level);
        lines.push_back(line);
      }
    if (lines.size() < 2)
      throw UserError(path, "has " + counted(lines.size(), "line"), allowed);
  }


  PhreaticLine
  PhreaticLines::at(const double level) const
  {
    if (lines.empty())
      return {};
    if (levels.empty() || level <= levels.front())
      return lines.front();
    if (level >= levels.back())
      return lines.back();
    std::size_t i = 1;
    while (level > levels[i])
      ++i;
    return PhreaticLine::between(lines[i - 1],
                                 lines[i],
                                 (level - levels[i - 1]) /
                                   (levels[i] - levels[i - 1]));
  }
} // namespace Waker
