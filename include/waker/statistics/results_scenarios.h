// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_statistics_results_scenarios_h
#define waker_statistics_results_scenarios_h

#include <waker/store/campaign_info.h>
#include <waker/store/hdf5_file.h>
#include <waker/store/record.h>

#include <vector>

namespace Waker
{
  /// What the store says of each scenario: its levels, scales and hash.
  void
  write_scenarios(Hdf5File &file, const CampaignInfo &info);

  /**
   * The counts and probabilities of each scenario: n, n_S1, n_F, and P_S1,
   * P_F, P_F_given_S1 in all readings with their 95 % intervals (*_low,
   * *_high) and what the estimate says (*_kind: EstimateKind). P_F_monotone is
   * NaN where the scenarios are not different water levels.
   *
   * @param records of scenarios of `info`, each realisation once
   */
  void
  write_estimates(Hdf5File                  &file,
                  const CampaignInfo        &info,
                  const std::vector<Record> &records);
} // namespace Waker

#endif
