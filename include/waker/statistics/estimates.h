// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_statistics_estimates_h
#define waker_statistics_estimates_h

#include <waker/statistics/intervals.h>
#include <waker/store/record.h>

#include <cstdint>
#include <string>
#include <vector>

namespace Waker
{
  /**
   * The three probabilities of chapter 5 of Remmerswaal (2023).
   *
   * The interval of P(F|S1) is that of a count of floods among the initial
   * failures that there happen to be: right whatever P(S1) is. A flood is an
   * initial failure, unless the water rose over a dyke that had not failed.
   */
  struct Estimate
  {
    Proportion initial;        // P(S1), (5.1)
    Proportion flooding;       // P(F), (5.2)
    Proportion flooding_given; // P(F|S1), (5.5); n is the count of S1
  };

  /**
   * All probabilities of one scenario.
   *
   * Realisations that failed numerically, and those that did not fail but were
   * not at rest, or under changing loads, or against the box when they ended,
   * are in no denominator. As both may well go with failing, `if_all_failed`
   * and `if_none_failed` are the probabilities if each of them had failed and
   * flooded, or nothing more had happened to it: what it had recorded of S1 and
   * F before counts in both. They bound P(S1) and P(F), not their ratio.
   *
   * An initial failure whose end is not final has not flooded so far, and
   * counts as such; `if_all_failed` lets it flood.
   */
  struct ScenarioEstimate
  {
    std::uint64_t n           = 0; // realisations that count
    std::uint64_t n_numerical = 0; // numerical failures: not in n
    // Undecided, not in n either:
    std::uint64_t n_still_moving   = 0;
    std::uint64_t n_loads_change   = 0;
    std::uint64_t n_stopped_by_box = 0;
    /// Of n: initial failures that have not flooded so far, but are not final.
    std::uint64_t n_not_final = 0;
    /// Of all: with points to which the draw gave what their law would refuse,
    /// and the most such points that one of them has.
    std::uint64_t n_beyond_law           = 0;
    std::uint64_t most_points_beyond_law = 0;

    std::uint64_t
    n_undecided() const
    {
      return n_still_moving + n_loads_change + n_stopped_by_box;
    }

    /// All that are not in n.
    std::uint64_t
    n_lost() const
    {
      return n_numerical + n_undecided();
    }

    /// Any reading of S1 (see FailureEvents), which is what is meant where
    /// none is named ...
    Estimate by_any;
    /// ... width or height ...
    Estimate by_geometry;
    /// ... the thesis's, W < W_i ...
    Estimate by_width;
    /// ... and displacement, with the slopes; of the realisations in which it
    /// was watched (not in records of version 0.1).
    Estimate   by_displacement;
    Proportion inner_slides;
    Proportion outer_slides;
    Estimate   if_all_failed;
    Estimate   if_none_failed;

    /// P(S1) and P(F) of those that count, between bounds that hold whatever
    /// the others would have done: what risks and verdicts are made of.
    BoundedProbability
    initial() const
    {
      return {by_any.initial.estimate,
              if_none_failed.initial.low,
              if_all_failed.initial.high};
    }
    BoundedProbability
    flooding() const
    {
      return {by_any.flooding.estimate,
              if_none_failed.flooding.low,
              if_all_failed.flooding.high};
    }
  };

  /// "15 of 30 undecided", numerical failures among them, "2 initial failures
  /// not final", both or "".
  std::string
  undecided_text(const std::uint64_t n_lost,
                 const std::uint64_t n_not_final,
                 const std::uint64_t n_all);

  /// One row of a table against time or number of realisations.
  struct EstimateRow
  {
    double   position; // s, or number of realisations
    Estimate estimate;
  };

  /// Whether it is known if the dyke failed.
  inline bool
  counts(const Record &record)
  {
    return is_decided(record.outcome);
  }

  /// @param records of one scenario, each realisation once; may be empty
  /// @param may_flood is there water? Else nothing is known of flooding.
  ScenarioEstimate
  estimate(const std::vector<Record> &records, const bool may_flood = true);

  /**
   * P(S1, t_S1 <= t), P(F, t_F <= t) and their ratio (5.1), (5.2): at 0, at
   * each moment at which an event occurred, and at the end of the longest
   * realisation; if these are more than `n_rows`, at `n_rows` equidistant
   * moments. A realisation that was stopped earlier counts as unchanged.
   */
  std::vector<EstimateRow>
  estimate_against_time(const std::vector<Record> &records,
                        const unsigned int         n_rows = 400);

  /**
   * The estimates from the first n realisations that count, in the order of
   * their numbers, for about `n_rows` values of n in geometric progression:
   * 1, 2, ... , all.
   */
  std::vector<EstimateRow>
  estimate_convergence(const std::vector<Record> &records,
                       const unsigned int         n_rows = 200);
} // namespace Waker

#endif
