// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_statistics_risk_h
#define waker_statistics_risk_h

#include <waker/statistics/analysis_parameters.h>
#include <waker/statistics/fragility.h>

#include <optional>
#include <string>

namespace Waker
{
  /// Whether a probability keeps within a budget: with its whole interval, or
  /// not even with the lower bound, or it cannot be told yet.
  enum class Verdict
  {
    met,
    not_met,
    undecided
  };

  /// "met", "not met", "undecided".
  std::string
  to_string(const Verdict verdict);

  Verdict
  compare(const BoundedProbability &probability, const double budget);

  struct Budget
  {
    double  budget;
    Verdict verdict;
  };

  /// Euro (per year if the probability is); what it says is what the
  /// probability does.
  struct Amount
  {
    double       estimate;
    double       low;
    double       high;
    EstimateKind kind;
  };

  /// What follows from a probability of flooding by macro-instability
  /// (section 4.2 of Remmerswaal 2023). Empty: P_s or C(F) is not known.
  struct Risk
  {
    /// P(F_i) <= (1 - reserve) P_s (4.8): what it leaves must do for all other
    /// mechanisms that are computed.
    std::optional<Budget> all_mechanisms;
    /// P(F_i) <= w_i P_s (4.9).
    std::optional<Budget> macro_instability;
    /// P(F) C(F) (4.1).
    std::optional<Amount> risk;
  };

  Risk
  assess_risk(const BoundedProbability &flooding,
              const RiskParameters     &parameters);

  /**
   * P(FoS < 1) by point statistics alone, for a normal strength whose factor
   * of safety is proportional to it: Phi((1 / FoS - 1) / COV) (section 5.4.1;
   * 0.1243 for FoS = 1.3, COV = 0.2, where the thesis prints 0.13).
   *
   * @param factor_of_safety with the mean strength, above 0
   * @param coefficient_of_variation above 0
   */
  double
  failure_by_point_statistics(const double factor_of_safety,
                              const double coefficient_of_variation);
} // namespace Waker

#endif
