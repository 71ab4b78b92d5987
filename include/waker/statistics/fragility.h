// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_statistics_fragility_h
#define waker_statistics_fragility_h

#include <waker/statistics/intervals.h>
#include <waker/store/campaign_info.h>
#include <waker/store/record.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace Waker
{
  /// The estimates at one swept water level.
  struct FragilityPoint
  {
    double     water_level; // h, m
    double     freeboard;   // crest of the drawn profile - h, m
    Proportion initial;     // P(S1|h), of the realisations that count
    Proportion flooding;    // P(F|h)

    /// Realisations that do not count, and initial failures that may yet flood
    /// (see ScenarioEstimate) ...
    std::uint64_t n_lost      = 0;
    std::uint64_t n_not_final = 0;
    /// ... and bounds that hold whatever these would have done. Without them
    /// the intervals above do.
    std::optional<Interval> initial_bounds  = {};
    std::optional<Interval> flooding_bounds = {};
  };

  /// By rising water level; scenarios without a realisation are left out, those
  /// in which none counts are not.
  /// Empty if two scenarios have the same level: then something else is swept.
  std::vector<FragilityPoint>
  fragility_points(const CampaignInfo                     &info,
                   const std::vector<std::vector<Record>> &records_by_scenario);

  /// In words which of the swept water levels are equal, so that there are no
  /// points; "" if none are, or something else is swept.
  std::string
  equal_levels_note(const CampaignInfo &info);

  /// The rising sequence that is nearest to `values` by weighted least
  /// squares (pool adjacent violators). Keeps the order of two sequences with
  /// the same weights: bounds stay bounds.
  std::vector<double>
  make_rising(const std::vector<double> &values,
              const std::vector<double> &weights);

  /**
   * A value against water level: through its points, between two neighbours
   * never beyond their values (piecewise cubic, slopes of Fritsch & Butland
   * 1984), constant below the first and above the last level.
   */
  class FragilityCurve
  {
  public:
    /// @param levels (m) at least one, strictly rising
    FragilityCurve(const std::vector<double> &levels,
                   const std::vector<double> &values);

    double
    operator()(const double level) const;

    /// Derivative (1/m); 0 outside the levels.
    double
    slope(const double level) const;

    std::vector<double> levels;
    std::vector<double> values;

  private:
    std::vector<double> slopes;
  };

  /// Reliability index beta of a probability and of its bounds, falling where
  /// the probability rises; NaN where it is not finite.
  struct BoundedIndex
  {
    double estimate;
    double low;  // of the upper bound of the probability
    double high; // of the lower one
  };

  BoundedIndex
  reliability_index(const BoundedProbability &probability);

  /// Estimate and bounds. Bounds are those of all levels at once, whatever the
  /// realisations that do not count would have done. The estimate leaves out
  /// levels at which none counts; it is NaN if there are no others.
  struct BoundedCurve
  {
    FragilityCurve estimate;
    FragilityCurve low;
    FragilityCurve high;

    /// Bounds are moved where interpolation, which is not linear, would make
    /// them cross the estimate.
    BoundedProbability
    at(const double level) const;

    /// The same, without an estimate where none of the realisations counts.
    BoundedProbability
    at(const FragilityPoint &point) const;
  };

  /// P(S1|h): as estimated, since it may fall and rise again with h (the outer
  /// slope fails at low water). @param points at least one
  BoundedCurve
  initial_failure_curve(const std::vector<FragilityPoint> &points);

  /**
   * P(F|h): higher water is not safer, so it is made to rise with h where
   * chance says otherwise (isotonic regression, weighted by n). Its bounds,
   * those of the levels made to rise in the same way, hold what they held: in
   * each pooled block they lie at or beyond a bound of a level from which
   * monotony carries over.
   */
  BoundedCurve
  flooding_curve(const std::vector<FragilityPoint> &points);


  /// Of the yearly maximum of the water level.
  class LevelDistribution
  {
  public:
    /// P(maximum > h) = 1 - exp(-exp(-(h - location) / scale)), both in m.
    static LevelDistribution
    gumbel(const double location, const double scale);

    /**
     * Levels (m, rising) and the probabilities per year that they are
     * exceeded (falling, above 0, at most 1); linear in the logarithm between
     * and beyond them (but never above 1).
     */
    static LevelDistribution
    table(const std::vector<double> &levels,
          const std::vector<double> &exceedance);

    /// A table as text: lines "level,probability"; titles in the first line
    /// and lines that begin with # are skipped.
    /// @throws UserError `name`:line
    static LevelDistribution
    parse_table(const std::string &text, const std::string &name);

    double
    exceedance(const double level) const;

    /// Levels of the table; empty for Gumbel's.
    const std::vector<double> &
    table_levels() const
    {
      return levels;
    }

  private:
    double              location = 0.;
    double              scale    = 1.;
    std::vector<double> levels;
    std::vector<double> logarithms;
  };


  /**
   * P = int P(.|h) f(h) dh (4.13), per year.
   *
   * Integrated by parts, P(h_1) + int P'(h) P(maximum > h) dh over the swept
   * levels: outside them the curve is constant. The bounds put all levels at
   * their bounds at once: the right thing with common random numbers, too wide
   * otherwise.
   */
  BoundedProbability
  yearly_probability(const BoundedCurve      &curve,
                     const LevelDistribution &distribution);
} // namespace Waker

#endif
