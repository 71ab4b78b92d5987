// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_statistics_intervals_h
#define waker_statistics_intervals_h

#include <cstdint>
#include <string>

namespace Waker
{
  /// Of every interval that Waker prints.
  constexpr double confidence_level = 0.95;

  struct Interval
  {
    double low;
    double high;
  };

  /// A probability estimated by counting: `count` of `n` independent
  /// realisations.
  struct Proportion
  {
    std::uint64_t count;
    std::uint64_t n;
    double        estimate; // count / n; NaN if n = 0
    double        low;      // of the interval of Clopper and Pearson
    double        high;
  };

  /// A probability with bounds.
  struct BoundedProbability
  {
    double estimate;
    double low;
    double high;
  };

  inline BoundedProbability
  bounded(const Proportion &p)
  {
    return {p.estimate, p.low, p.high};
  }

  /// What an estimate of a probability says by itself: with no event counted
  /// only the upper end of its interval says anything, with nothing but events
  /// only the lower one.
  enum class EstimateKind
  {
    estimate,
    upper_bound,
    lower_bound,
    unknown // nothing was counted
  };

  /// "estimate", "upper bound", "lower bound", "unknown".
  std::string
  to_string(const EstimateKind kind);

  /// Of a probability: 0 is an upper bound, 1 a lower one, NaN unknown.
  EstimateKind
  kind_of(const double estimate);

  /**
   * The exact interval of a probability after `count` of `n` (Clopper &
   * Pearson 1934): quantiles of the beta distribution. Whatever the
   * probability is, at least `confidence` of all campaigns get an interval
   * that holds it (usually more, as counts are whole numbers); both tails
   * have (1 - confidence) / 2 at most, so that `high` after no event at all is
   * 1 - (0.025)^(1/n), about 3.7 / n. [0, 1] if n = 0.
   */
  Interval
  clopper_pearson(const std::uint64_t count,
                  const std::uint64_t n,
                  const double        confidence = confidence_level);

  Proportion
  proportion(const std::uint64_t count, const std::uint64_t n);

  /// Standard normal distribution function Phi(x), accurate in its lower tail.
  double
  normal_distribution(const double x);

  /// beta = -Phi^-1(P); infinity at P = 0, -infinity at P = 1, NaN of NaN.
  double
  reliability_index(const double probability);

  /// Of the estimate count / n: sqrt((1 - P) / (n P)); infinity if count = 0.
  double
  coefficient_of_variation(const std::uint64_t count, const std::uint64_t n);

  /// P -+ 1.96 sqrt(P (1 - P) / n), not cut off at 0 and 1: for comparison
  /// only, useless for counts below about 10. NaN if n = 0.
  Interval
  normal_interval(const std::uint64_t count, const std::uint64_t n);
} // namespace Waker

#endif
