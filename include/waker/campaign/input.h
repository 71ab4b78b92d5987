// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef waker_campaign_input_h
#define waker_campaign_input_h

#include <waker/campaign/campaign_parameters.h>
#include <waker/case/parameters.h>
#include <waker/fields/parameters.h>
#include <waker/statistics/analysis_parameters.h>

#include <string>

namespace Waker
{
  /// What a .prm file says about chance.
  struct ReliabilityParameters
  {
    RandomFieldsParameters fields;
    CampaignParameters     campaign;
    SweepParameters        sweep;
    SnapshotParameters     snapshots;
    AnalysisParameters     analysis;

    /// All checks of single structs. @throws UserError
    void
    check(const unsigned int dim) const;
  };


  /// All that a .prm file says. Made by `program/`; must not move while
  /// entries are set.
  struct Input
  {
    Parameters            simulation;
    ReliabilityParameters reliability;

    /// Of all that decides the records of a realisation: also stop rules and
    /// seed, but neither output nor the number of realisations nor the sweep.
    std::string campaign_hash;

    /// All checks that need no grid. @throws UserError
    void
    check() const;

    /// Tell the materials which properties have random fields that their laws
    /// must know of.
    void
    prepare_materials();
  };
} // namespace Waker

#endif
