// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/base/errors.h>
#include <waker/reliability/fragility.h>

#include <algorithm>
#include <cmath>
#include <locale>
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
    std::istringstream  lines(text);
    std::string         line;
    bool                may_be_titles = true;
    for (unsigned int number = 1; std::getline(lines, line); ++number)
      {
        if (line.find_first_not_of(" \t\r") == std::string::npos ||
            line[line.find_first_not_of(" \t")] == '#')
          continue;
        const auto complain = [&](const std::string &problem,
                                  const std::string &allowed) {
          throw UserError(name + ":" + std::to_string(number),
                          problem,
                          allowed);
        };

        std::istringstream stream(line);
        stream.imbue(std::locale::classic());
        double      level = 0., probability = 0.;
        char        comma = 0;
        std::string rest;
        const bool  good = (stream >> level >> comma >> probability) &&
                          comma == ',' && !(stream >> rest);
        const bool is_first = may_be_titles;
        may_be_titles       = false;
        if (!good && is_first)
          continue;
        if (!good)
          complain("'" + line + "' is not a level and a probability",
                   "two numbers with a comma between them");
        if (!(probability > 0. && probability <= 1.))
          complain("the probability in '" + line + "' is out of range",
                   "above 0, at most 1");
        if (!levels.empty() &&
            !(level > levels.back() && probability < exceedance.back()))
          complain("'" + line + "' does not continue the table",
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
