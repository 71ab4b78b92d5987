// SPDX-License-Identifier: LGPL-2.1-or-later
#include <deal.II/base/exceptions.h>

#include <waker/statistics/intervals.h>
#include <waker/statistics/risk.h>

namespace Waker
{
  std::string
  to_string(const Verdict verdict)
  {
    switch (verdict)
      {
        case Verdict::met:
          return "met";
        case Verdict::not_met:
          return "not met";
        case Verdict::undecided:
          return "undecided";
      }
    Assert(false, dealii::ExcInternalError());
    return "";
  }


  Verdict
  compare(const BoundedProbability &probability, const double budget)
  {
    if (probability.high <= budget)
      return Verdict::met;
    return probability.low > budget ? Verdict::not_met : Verdict::undecided;
  }


  Risk
  assess_risk(const BoundedProbability &flooding,
              const RiskParameters     &parameters)
  {
    Risk result;
    if (parameters.allowed_probability > 0.)
      {
        const double p_s   = parameters.allowed_probability;
        const double all   = (1. - parameters.reserve) * p_s;
        const double share = parameters.share * p_s;

        result.all_mechanisms    = {all, compare(flooding, all)};
        result.macro_instability = {share, compare(flooding, share)};
      }
    if (parameters.consequence > 0.)
      result.risk = Amount{flooding.estimate * parameters.consequence,
                           flooding.low * parameters.consequence,
                           flooding.high * parameters.consequence,
                           kind_of(flooding.estimate)};
    return result;
  }


  double
  failure_by_point_statistics(const double factor_of_safety,
                              const double coefficient_of_variation)
  {
    Assert(factor_of_safety > 0. && coefficient_of_variation > 0.,
           dealii::ExcInternalError());
    return normal_distribution((1. / factor_of_safety - 1.) /
                               coefficient_of_variation);
  }
} // namespace Waker
