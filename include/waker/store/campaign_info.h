// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_store_campaign_info_h
#define waker_store_campaign_info_h

#include <waker/base/numbers.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace Waker
{
  /// One value of a parameter sweep.
  struct ScenarioInfo
  {
    std::string value; // as the user wrote it; empty without a sweep
    /// At which W is measured, m; NaN: there is none.
    double water_level = nan;
    /// Crest (drawn_crest()) and lowest corner of the drawn profile, m; NaN:
    /// not known.
    double              crest_level = nan;
    double              base_level  = nan;
    std::vector<double> scales; // of fluctuation of the first field, m
    std::string         hash;   // of all that decides its realisations

    /// Without water nothing floods.
    bool
    may_flood() const
    {
      return std::isfinite(water_level);
    }
  };

  /**
   * What the realisations of a campaign have in common: campaign.json in its
   * folder, written once. Journals of another hash do not belong to it.
   */
  struct CampaignInfo
  {
    static constexpr unsigned int current_schema_version = 2; // 1: no checksum

    unsigned int              schema_version = current_schema_version;
    std::string               version; // of the program
    std::string               compiler;
    std::string               build_flags;
    std::uint64_t             seed         = 0;
    std::uint64_t             realisations = 0; // planned per scenario
    std::string               hash;             // over all scenarios
    std::string               swept_parameter;  // "Water/Level", or empty
    std::vector<ScenarioInfo> scenarios;        // at least one
    std::string               parameters;       // the whole .prm

    /// Do the scenarios differ in the water level? Only then is there a
    /// fragility curve.
    bool
    sweeps_water_level() const
    {
      return swept_parameter == "Water/Level";
    }

    void
    write(const std::string &path) const;

    /// @throws UserError with the path: missing, damaged (its checksum tells),
    /// newer schema
    static CampaignInfo
    read(const std::string &path);

    /// Is a file JSON, and its checksum right?
    static bool
    is_whole(const std::string &path);
  };
} // namespace Waker

#endif
