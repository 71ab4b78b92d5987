// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_statistics_yearly_h
#define waker_statistics_yearly_h

#include <waker/statistics/fragility.h>
#include <waker/statistics/risk.h>

#include <optional>
#include <string>
#include <vector>

namespace Waker
{
  /// What a sweep of the water level and a distribution of its yearly maximum
  /// say together (4.13). Probabilities are per year.
  struct Yearly
  {
    BoundedProbability initial;  // P(S1)
    BoundedProbability flooding; // P(F)
    /// Of the yearly highest level: below the lowest swept one, above the
    /// highest, above the crest.
    double below_the_lowest;
    double above_the_highest;
    double above_the_crest;
    /// Part of P(F) that comes from above the highest swept level; NaN if P(F)
    /// is 0.
    double share_from_above;
    Risk   risk;
    /// Of all levels, in words; see undecided_text().
    std::string undecided;
  };

  /**
   * Nothing without a distribution, or without a sweep of Water/Level with
   * realisations at two levels or more.
   *
   * @param notes gets in words what is missing, or what has been assumed
   */
  std::optional<Yearly>
  yearly(const bool                              sweeps_water_level,
         const std::vector<FragilityPoint>      &points,
         const std::optional<LevelDistribution> &distribution,
         const RiskParameters                   &parameters,
         std::vector<std::string>               &notes);

  /// In words which realisations do not count, at which levels or values, and
  /// what that does to bounds; nothing if all count.
  std::vector<std::string>
  undecided_notes(const CampaignInfo                     &info,
                  const std::vector<std::vector<Record>> &records_by_scenario);

  /// In words where the counted probabilities fall with rising water, and what
  /// is made of that; where no estimate is finite.
  std::vector<std::string>
  fragility_notes(const std::vector<FragilityPoint> &points);
} // namespace Waker

#endif
