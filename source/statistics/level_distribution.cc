// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/base/errors.h>
#include <waker/base/numbers.h>
#include <waker/base/text.h>
#include <waker/statistics/fragility.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Waker
{
  LevelDistribution
  LevelDistribution::gumbel(const double location, const double scale)
  {
    Assert(scale > 0., dealii::ExcInternalError());
    LevelDistribution result;
    result.location = location;
    result.scale    = scale;
    return result;
  }


  LevelDistribution
  LevelDistribution::table(const std::vector<double> &levels,
                           const std::vector<double> &exceedance)
  {
    AssertDimension(levels.size(), exceedance.size());
    Assert(levels.size() >= 2, dealii::ExcInternalError());
    LevelDistribution result;
    result.levels = levels;
    for (const double probability : exceedance)
      result.logarithms.push_back(std::log(probability));
    return result;
  }


  LevelDistribution
  LevelDistribution::parse_table(const std::string &text,
                                 const std::string &name)
  {
    std::vector<double> levels, exceedance;
    std::istringstream  lines(without_byte_order_mark(text));
    std::string         line;
    bool                may_have_titles = true;
    for (unsigned int number = 1; std::getline(lines, line); ++number)
      {
        line = tidy(line);
        if (line.empty() || line[0] == '#')
          continue;
        const auto complain = [&](const std::string &problem,
                                  const std::string &allowed) {
          throw UserError(name + ":" + std::to_string(number),
                          in_quotes(line) + " " + problem,
                          allowed);
        };
        const bool is_first = may_have_titles;
        may_have_titles     = false;
        if (is_first && may_be_titles(line))
          continue;

        const std::vector<std::string> parts = split(line, ',');
        double                         level = 0., probability = 0.;
        if (parts.size() != 2 || !read_number(parts[0], level) ||
            !read_number(parts[1], probability))
          complain("is not a level and a probability",
                   std::string("two numbers with a comma between them") +
                     decimals_with_a_point);
        if (!(probability > 0. && probability <= 1.))
          complain("has a probability out of range", "above 0, at most 1");
        if (!levels.empty() &&
            !(level > levels.back() && probability < exceedance.back()))
          complain("does not continue the table",
                   "rising levels and falling probabilities");
        levels.push_back(level);
        exceedance.push_back(probability);
      }
    if (levels.size() < 2)
      throw UserError(name,
                      "has " + std::to_string(levels.size()) +
                        " lines with a level and a probability",
                      "two or more");
    return table(levels, exceedance);
  }


  double
  LevelDistribution::exceedance(const double level) const
  {
    if (levels.empty()) // expm1: for small probabilities
      return -std::expm1(-std::exp(-(level - location) / scale));
    const std::size_t after =
      std::upper_bound(levels.begin() + 1, levels.end() - 1, level) -
      levels.begin();
    const double share =
      (level - levels[after - 1]) / (levels[after] - levels[after - 1]);
    return std::min(1.,
                    std::exp(logarithms[after - 1] +
                             share *
                               (logarithms[after] - logarithms[after - 1])));
  }
} // namespace Waker
