// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/simulation/factor_search.h>

#include <algorithm>
#include <cmath>

namespace Waker
{
  std::string
  to_string(const TrialResult result)
  {
    switch (result)
      {
        case TrialResult::stable:
          return "stable";
        case TrialResult::failed:
          return "failed";
        case TrialResult::undecided:
          return "undecided";
      }
    return "";
  }


  FactorSearch::FactorSearch(const double lower,
                             const double upper,
                             const double tolerance)
    : lower(lower)
    , upper(upper)
    , tolerance(tolerance)
  {}


  std::optional<double>
  FactorSearch::next() const
  {
    if (has_ended)
      return {};
    if (!stable)
      return lower;
    if (!failed)
      return upper;
    if (factor() || between.size() >= max_undecided)
      return {};
    // The widest gap; the first of equal ones, so that the order is fixed.
    double begin = *stable, widest = 0., middle = 0.;
    for (std::size_t k = 0; k <= between.size(); ++k)
      {
        const double end = k < between.size() ? between[k] : *failed;
        if (end - begin > widest)
          {
            widest = end - begin;
            middle = 0.5 * (begin + end);
          }
        begin = end;
      }
    if (widest <= tolerance)
      return {};
    return middle;
  }


  void
  FactorSearch::add(const TrialResult result)
  {
    const std::optional<double> tried = next();
    AssertThrow(tried, dealii::ExcMessage("the search is over"));
    const bool is_lower = !stable, is_upper = stable && !failed;
    // Which side an end must be on.
    has_ended = (is_lower && result != TrialResult::stable) ||
                (is_upper && result != TrialResult::failed);
    if (result == TrialResult::stable)
      stable = tried;
    else if (result == TrialResult::failed)
      failed = tried;
    else
      between.push_back(*tried);
    std::sort(between.begin(), between.end());
    if (stable && failed)
      between.erase(std::remove_if(between.begin(),
                                   between.end(),
                                   [&](const double factor) {
                                     return factor <= *stable ||
                                            factor >= *failed;
                                   }),
                    between.end());
  }


  std::optional<double>
  FactorSearch::highest_stable() const
  {
    return stable;
  }


  std::optional<double>
  FactorSearch::lowest_failed() const
  {
    return failed;
  }


  std::optional<double>
  FactorSearch::factor() const
  {
    if (has_ended || !stable || !failed || *failed - *stable > tolerance)
      return {};
    return 0.5 * (*stable + *failed);
  }


  unsigned int
  FactorSearch::n_left() const
  {
    if (!next())
      return 0;
    const double from = stable.value_or(lower), to = failed.value_or(upper);
    const double halvings = std::ceil(std::log2((to - from) / tolerance));
    return (stable ? 0 : 1) + (failed ? 0 : 1) +
           static_cast<unsigned int>(std::clamp(halvings, 0., 1000.));
  }
} // namespace Waker
