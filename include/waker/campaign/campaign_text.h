// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_campaign_text_h
#define waker_campaign_campaign_text_h

#include <waker/campaign/folder_keeper.h>
#include <waker/campaign/progress.h>
#include <waker/store/campaign_info.h>

#include <cstdint>
#include <string>

namespace Waker
{
  /// What has been computed by all ranks of this start of the program.
  struct Work
  {
    std::uint64_t n      = 0;  // realisations
    double        busy   = 0.; // s, spent on them since this start
    double        fields = 0.; // s, of which for random fields
    double        wall   = 0.; // s, of the slowest rank
  };

  /// "12.3 s", "4.5 min", "2.1 h"
  std::string
  work_time_text(const double seconds);

  /// What is about to be computed: hash, scenarios, number, seed, ranks.
  std::string
  campaign_text(const CampaignInfo &info,
                const int           n_ranks,
                const unsigned int  ranks_per_realisation);

  /// "84 of at most 200, S1 12, flooded 9, P(F) = 0.107 [0.0502, 0.194]"; the
  /// probability only of a single scenario, without water that of S1.
  std::string
  progress_text(const Progress &progress, const CampaignInfo &info);

  /// "; no. 17 at t = 3.2 s"
  std::string
  running_text(const std::uint64_t realisation, const double time);

  /// "realisation 17 of scenario 0: under way, at t = 3.2 s (4 s ago),
  /// checkpoint at t = 2.9 s"
  std::string
  running_text(const RunningRealisation &running);

  /// "200 realisations in 45 s on 2 rank(s): 8000 an hour and core; ranks busy
  /// 99.1 %; random fields 0.02 s each"
  std::string
  work_text(const Work &work, const int n_ranks);

  /// "120 realisations an hour and core; at most 2.1 h of one core to go"; ""
  /// where nothing is known of the time that they take.
  /// @param busy sum over those that are done of wall time times ranks (s)
  std::string
  pace_text(const std::uint64_t n_done,
            const std::uint64_t n_wanted,
            const double        busy);
} // namespace Waker

#endif
