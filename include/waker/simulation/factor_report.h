// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_simulation_factor_report_h
#define waker_simulation_factor_report_h

#include <waker/simulation/factor_search.h>
#include <waker/simulation/trial_table.h>

#include <string>

namespace Waker
{
  /// "factor 1.2500: failed at t = 2.90 s (initial failure), by ...".
  std::string
  describe_trial(const double factor, const Trial &trial);

  /// The contents of strength_reduction.json.
  /// @param strengths which were reduced
  /// @param hash of the parameters
  std::string
  search_json(const FactorSearch &search,
              const TrialTable   &table,
              const std::string  &strengths,
              const std::string  &hash);

  /// The factor of safety, or why there is none.
  std::string
  search_conclusion(const FactorSearch &search, const TrialTable &table);
} // namespace Waker

#endif
